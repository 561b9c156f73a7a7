//! Formulas as they stand in textbooks on vibrations.

use vibank::document::read_math;

/// LaTeX with its plain text.
pub(crate) const FORMULAS: &[(&str, &str)] = &[
    // An accent over nothing leaves the letter before it alone.
    (r"t\ddot{}u", "t ddot()u"),
    (r"t\ddot\ u", "t ddot( )u"),
    (r"\omega_n = \sqrt{\frac{k}{m}}", "ωₙ = √(k/m)"),
    (
        r"m\ddot x + c\dot x + k x = F_0\sin\Omega t",
        "mẍ + cẋ + kx = F₀ sin Ωt",
    ),
    (
        r"x(t) = A e^{-\zeta\omega_n t}\cos(\omega_d t - \varphi)",
        "x(t) = Ae^(−ζωₙ t) cos(ω_d t − φ)",
    ),
    (
        r"\omega_d = \omega_n\sqrt{1 - \zeta^2}",
        "ω_d = ωₙ √(1 − ζ²)",
    ),
    (
        r"\delta = \ln\frac{x_1}{x_2} = \frac{2\pi\zeta}{\sqrt{1-\zeta^2}}",
        "δ = ln x₁/x₂ = (2πζ)/√(1 − ζ²)",
    ),
    (
        r"\frac{1}{2}m\dot{x}^2 + \frac12 k x^2 = E",
        "1/2 mẋ² + 1/2 kx² = E",
    ),
    (r"\tfrac{3}{2}m\,\ddot{x}", "3/2 m ẍ"),
    (
        r"f = \dfrac{1}{2\pi}\sqrt{\dfrac{g}{\ell}}",
        "f = 1/(2π) √(g/ℓ)",
    ),
    (
        r"\theta'' + \frac{g}{\ell}\sin\theta = 0",
        "θ′′ + g/ℓ sin θ = 0",
    ),
    (r"x_1''(t)^2", "x₁′′(t)²"),
    (r"\ddot\theta_1, \dddot{x}", "θ̈₁, x⃛"),
    (
        r"M\ddot{\mathbf{x}} + K\mathbf{x} = \mathbf 0",
        "Mẍ + Kx = 0",
    ),
    (
        r"\begin{bmatrix} m_1 & 0 \\ 0 & m_2 \end{bmatrix}",
        "[[m₁, 0], [0, m₂]]",
    ),
    (r"\begin{pmatrix} 1 \\ -0.618 \end{pmatrix}", "[1, −0.618]"),
    (r"\det\left(K - \omega^2 M\right) = 0", "det(K − ω²M) = 0"),
    (
        r"\begin{vmatrix} 2k - m\omega^2 & -k \\ -k & k - m\omega^2 \end{vmatrix} = 0",
        "|[[2k − mω², −k], [−k, k − mω²]]| = 0",
    ),
    (
        r"F(t) = \begin{cases} F_0 & 0 \le t < t_1 \\ 0 & \text{else} \end{cases}",
        "F(t) = {F₀, 0 ≤ t < t₁; 0, else",
    ),
    (
        r"\begin{aligned} m\ddot x &= -kx - c\dot x \\ &= -k\left(x + \frac{c}{k}\dot x\right) \end{aligned}",
        "mẍ = −kx − cẋ = −k(x + c/k ẋ)",
    ),
    (r"\sum_{i=1}^{n} m_i \dot x_i^2", "∑_(i = 1)^n mᵢ ẋᵢ²"),
    (r"\int_0^T F(t)\,\mathrm{d}t", "∫_0^T F(t) dt"),
    (
        r"\frac{\mathrm d}{\mathrm dt}\frac{\partial L}{\partial \dot q_i} - \frac{\partial L}{\partial q_i} = Q_i",
        "d/(dt) (∂L)/(∂q̇ᵢ) − (∂L)/(∂qᵢ) = Qᵢ",
    ),
    (
        r"X = \frac{F_0/k}{\sqrt{(1-r^2)^2 + (2\zeta r)^2}}",
        "X = (F₀/k)/√((1 − r²)² + (2ζr)²)",
    ),
    (
        r"\phi = \arctan\frac{2\zeta r}{1 - r^2}",
        "ϕ = arctan (2ζr)/(1 − r²)",
    ),
    (
        r"T = 2\pi\sqrt{\frac{I_O}{m g d}}\,\text{ for small angles}",
        "T = 2π√(I_O/(mgd)) for small angles",
    ),
    (r"9.81\,\mathrm{m/s^2}", "9.81 m/s²"),
    (r"2{,}52\,\mathrm{Hz}", "2,52 Hz"),
    (r"3\times 10^{-4}\,\mathrm{kg\,m^2}", "3 × 10⁻⁴ kg m²"),
    (r"\qty{2}{kg}", "2 kg"),
    (r"\mu_\mathrm{crit} < 0.35", "μ_crit < 0.35"),
    (r"\operatorname{sgn}(\dot x)", "sgn(ẋ)"),
    (r"\left|\frac{x_1}{x_0}\right| \le 1", "|x₁/x₀| ≤ 1"),
    (r"\lvert x\rvert > \delta", "|x| > δ"),
    (
        r"x_{1,2} = -\zeta\omega_n \pm i\omega_d",
        "x_(1, 2) = −ζωₙ ± iω_d",
    ),
    (r"\lim_{t\to\infty} x(t) = 0", "lim_(t → ∞) x(t) = 0"),
    (
        r"\max_{0\le t\le T} \lvert x(t)\rvert",
        "max_(0 ≤ t ≤ T) |x(t)|",
    ),
    (r"\vec F = m\vec a", "F⃗ = ma⃗"),
    (
        r"\overline{AB} = \hat u + \tilde v + \bar w",
        "bar(AB) = û + ṽ + w̄",
    ),
    (r"\sqrt[3]{\frac{a+b}{2}}", "³√((a + b)/2)"),
    (r"\sqrt[n+1]{x}", "ⁿ⁺¹√(x)"),
    (
        r"e^{i\Omega t} = \cos\Omega t + i\sin\Omega t",
        "e^(iΩt) = cos Ωt + i sin Ωt",
    ),
    (
        r"\boldsymbol{\Phi}^T \mathbf{M} \boldsymbol{\Phi} = \mathbf{I}",
        "ΦᵀMΦ = I",
    ),
    (r"\Delta E \approx \pi c \Omega X^2", "ΔE ≈ πcΩX²"),
    (
        r"\underbrace{m\ddot x}_{\text{inertia}} + kx = 0",
        "(mẍ)_inertia + kx = 0",
    ),
    (r"k_\text{eq} = k_1 + k_2", "k_eq = k₁ + k₂"),
    (r"\alpha = 30^\circ", "α = 30°"),
    (r"30\degree < \theta_0^\circ", "30° < θ₀°"),
    (
        r"\begin{cases} 1 & x > 0 \\ [-1, 1] & x = 0 \end{cases}",
        "{1, x > 0; [−1, 1], x = 0",
    ),
    (r"\binom{n}{k}", "(n/k)"),
    (
        r"K(m) = \int_0^{\pi/2} \frac{\mathrm{d}\theta}{\sqrt{1 - m\sin^2\theta}}",
        "K(m) = ∫_0^(π/2) (dθ)/√(1 − m sin² θ)",
    ),
    (
        r"\mathcal{L}\{f\} = \int_0^\infty f e^{-st}\,\mathrm dt \in \mathbb{C}",
        "L{f} = ∫_0^∞ fe^(−st) dt ∈ C",
    ),
    (r"x \xrightarrow{t \to \infty} 0", "x →^(t → ∞) 0"),
    (r"r = \Omega/\omega_n \ne 1", "r = Ω/ωₙ ≠ 1"),
    (r"\sum\limits_{r} \phi_r q_r", "∑_r ϕᵣ qᵣ"),
    (
        r"a \ll b \Rightarrow \varepsilon \propto \frac ab",
        "a ≪ b ⇒ ε ∝ a/b",
    ),
    (r"[0, \mu_\mathrm{crit})", "[0, μ_crit)"),
    (r"x^* = a - -b", "x^∗ = a − −b"),
    (r"\frac{\partial^2 w}{\partial x^2}", "(∂²w)/(∂x²)"),
    (
        r"w(x,t) = \sum_{n=1}^\infty W_n(x)\,q_n(t)",
        "w(x, t) = ∑_(n = 1)^∞ Wₙ(x) qₙ(t)",
    ),
];

#[test]
fn formulas_read_back_from_their_latex() {
    for (source, _) in FORMULAS {
        let math = read_math(source).unwrap_or_else(|error| panic!("{source}: {error}"));
        let latex = math.latex();
        let again = read_math(&latex).unwrap_or_else(|error| panic!("{latex}: {error}"));
        assert_eq!(again, math, "{source}\n{latex}");
        assert_eq!(again.latex(), latex);
    }
}

#[test]
fn formulas_read_well_in_plain_text() {
    let mut wrong = Vec::new();
    for (source, plain) in FORMULAS {
        let written = read_math(source).unwrap().plain();
        if written != *plain {
            wrong.push(format!("{source}\n  {written}\n  {plain}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn compiled_formulas_keep_their_trees() {
    for (source, _) in FORMULAS {
        let math = read_math(source).unwrap();
        let json = serde_json::to_string(&math).unwrap();
        assert_eq!(
            serde_json::from_str::<vibank::math::Math>(&json).unwrap(),
            math
        );
    }
}
