"""Numbers, quantities and units as people type them, for tests/corpora/numbers.tsv.

Each line has the unit that is asked, the response, and what it has to be read as: the value in SI units (radians, or
cycles per second where hertz are asked), `unreadable`, or `dimension`. Values are products of a decimal that is written
out here and the factor of a unit from the SI Brochure, with 40 digits.

    python3 tests/references/typed_numbers.py > tests/corpora/numbers.tsv
"""

from decimal import Decimal as D
from decimal import getcontext

getcontext().prec = 40
PI = D("3.141592653589793238462643383279502884197")
ROWS = []


def row(asked, response, value):
    ROWS.append((asked, response, value))


def same(asked, value, *responses):
    for response in responses:
        row(asked, response, D(value) if not isinstance(value, D) else value)


# Decimals.
same("m", "2.52", "2.52", "2,52", "2.52 m", "2,52 m", "2.52m", " 2.52  m ", "+2.52 m", "2.520 m", "x = 2.52 m", "x=2,52m", "x ≈ 2.52 m", "252 cm", "2520 mm", "0.00252 km", "2.52 metres", "2.52 meters", "2.52·m", "2.52 * m", "2.52 \\mathrm{m}", "$2.52\\,m$")
same("m", "-1.5", "-1.5", "−1.5 m", "–1,5 m", "- 1.5 m", "-150 cm")
same("m", "0.5", ".5", ",5 m", "0,5", "0.5", "5e-1", "5E-1 m", "1/2", "1/2 m", "½ m", "50 cm", "500mm", "5·10^-1 m")
same("m", "3e-4", "3e-4", "3E-4", "3×10^-4", "3 × 10^-4 m", "3·10⁻⁴ m", "3*10^-4", "3*10^(-4)", "3*10**-4 m", "3x10^-4", "3 \\cdot 10^{-4} m", "3 \\times 10^{-4}", "0.3 mm", "300 µm", "300 um", "300 μm", "0,0003")
same("m", "5e-3", "5e-3 m", "5 mm", "0.005 m", "0,005 m", "0.5 cm", "5·10⁻³ m", "5e-6 km", "5000 um", "5.0 mm")
same("m", "1200", "1200", "1 200", "1 200 m", "1,200.0 m", "1.200,0", "1.2 km", "1,2 km", "1.2e3", "1200.", "12e2 m", "1.2 10^3 m")
same("m", "1234567", "1,234,567 m", "1 234 567 m", "1.234.567", "1234567")
same("m", "10", "10", "10 m", "10^1", "1e1", "10¹ m")
same("m", "1e-4", "10^-4", "10⁻⁴ m", "0.1 mm", "1e-4")
same("m", "0", "0", "0 m", "0.0", "0 mm", "0,0 cm")
# Arithmetic.
same("m", D(1) / 3, "1/3", "1/3 m", "2/6 m", "1 / 3 m", "\\frac{1}{3} m", "(1/3) m", "(1+1)/6", "100/3 cm")
same("m", D(2).sqrt() / 2, "sqrt(2)/2", "sqrt(2)/2 m", "√2/2 m", "√(2)/2", "1/sqrt(2) m", "2^(-1/2)", "0.5*sqrt(2) m", "50√2 cm", "sqrt(0.5)", "\\frac{\\sqrt{2}}{2} m")
same("rad/s", 2 * PI, "2*pi rad/s", "2pi rad/s", "2π rad/s", "2 π", "2π", "2 pi rad/s", "1 Hz", "60 rpm", "1 rev/s", "2*pi", "2π 1/s", "2π s^-1")
same("rad/s", 5 * PI, "5π", "10π/2 rad/s", "2.5 Hz", "150 rpm", "2π·2.5 rad/s", "2*pi*2,5")
same("rad", PI / 6, "pi/6", "π/6", "π/6 rad", "30°", "30 °", "30 deg", "30 degrees", "30^\\circ", "1/12 rev", "\\frac{\\pi}{6}", "-(-pi/6)", "60°/2")
same("rad", PI, "pi", "π", "180°", "180 deg", "0.5 rev", "1 π")
same("rad", -PI / 2, "-π/2", "−90°", "-pi/2 rad", "-1/2 pi")
same("m", "0.3", "0.1+0.2", "0.1 + 0.2 m", "3*0.1 m", "3·10^-1")
same("m", "20", "2*10 m", "4*5", "40/2 m", "(12 + 8) m", "2e1 m", "2*10^1 m")
same("1", D(3).sqrt(), "sqrt(3)", "√3", "3^0.5", "3^(1/2)", "3**0.5")
same("1", D(1).exp(), "exp(1)", "e^1")
same("1", D(-1).exp(), "exp(-1)", "e^-1", "e^(-1)", "1/exp(1)")
same("1", "0.25", "1/4", "25 %", "25%", "0,25", "0.25", "2.5e-1", "(1/2)^2", "0.5²")
same("1", "8", "2^3", "2**3", "2³", "8")
# Degrees behind arithmetic hold for all of it, but for what has π or its own sign.
same("rad", D("60.5") * PI / 180, "60°30'", "60° 30′", "+60°30'0\"", "60°29'60\"")
same("rad", -D("53.13") * PI / 180, "-53°7'48\"", "−53° 7′ 48″", "-53º7'48''")
same("rad/s", D("1.59") * 2 * PI, "1.59 in Hz")
same("rad", D("198.7") * PI / 180, "198.7°", "397.4/2 deg", "397.4/2°", "180 + 18.7 deg", "-180+378.7°", "360 - 161.3 deg", "180° + 18.7°", "(397.4/2) deg", "2*99.35°", "φ = 180° + 18.7°", "π + 18.7°")
same("rad", D("-161.3") * PI / 180, "18.7° - 180°", "18.7 - 180 deg", "-161.3 degrees")
# Chains of equal sides, names, marks behind a number.
same("m", "2.52", "x = sqrt(6.3504) = 2.52 m", "x = sqrt(k/m) = 2.52 m", "x = a*b ≈ 2.52 m", "2.52 m = x", "x = 252 cm = 2.52 m", "x(0.5 s) = 2.52 m", "x_{max}: 2.52 m", "x := 2.52", "x \\approx 2.52 m", "maximum displacement = 2.52", "|x| = 2.52 m", "x (m) = 2.52 m", "x(t) = 2.52", "2.52.")
same("1", "0.25", "0.25 [-]", "0.25 (-)", "ζ = 0.25 [-]")
# Sums of quantities, products and powers of ten in other signs.
same("m", "0.162", "400 mm - 238 mm", "0.1 m + 62 mm", "(400-238) mm", "400 - 238 mm", "162·10^-3 m", "16.2 e-2 m", "162X10^-3 m", "162e–3 m", "2x81 mm", "hypot(0, 162) mm")
same("m", "1250", "1'250 m", "1’250", "1.25 e3")
same("m/s^2", "5", "5 m/s/s", "5 m/s²", "5 m s-2")
same("rad", PI / 3, "Pi/3", "PI/3", "π⁄3")
# Units by dimension.
same("rad/s", "10", "10 rad/s", "10 s^-1", "10 1/s", "10/s", "10 s⁻¹", "10", "10 rad s^-1", "10 rad·s⁻¹", "10 rads/s", "10 radians per second", "10 Rad/s", "10 rad/sec", "0.01 rad/ms", "ω = 10 rad/s", "ω (rad/s) = 10", "ω [rad/s] = 10", "ω/(rad/s) = 10", "10 in rad/s", "10 rad/s approx", "10 rad/s, approx.", "10 rad/s (1.59 Hz)", "10 rad/s or 1.59 Hz", "omega_n = 10 rad/s", "10 \\frac{rad}{s}", "600 rad/min")
same("rad/s", 2 * PI * D("1.5915"), "1.5915 Hz", "1,5915 Hz", "1.5915 hz", "1591.5 mHz", "0.0015915 kHz")
same("rad/s", D("95.49") * PI / 30, "95.49 rpm", "95.49 rev/min", "95,49 RPM")
same("rad/s", 20 * PI, "10 Hz", "600 rpm", "10 rev/s")
same("Hz", "2.52", "2.52 Hz", "2,52 Hz", "2.52", "2.52 1/s", "2.52/s", "151.2 rpm", "2520 mHz", "2.52 hertz", "2.52 cycles/s")
same("Hz", 10 / (2 * PI), "10 rad/s")
same("N s/m", "100", "100 N s/m", "100 kg/s", "100 Ns/m", "100 N·s/m", "100 N*s/m", "100 N.s/m", "100 N s m^-1", "0.1 kN s/m", "0.1 N s/mm", "100 N/(m/s)", "100", "100 N/(m·s⁻¹)", "100 kg s^-1", "100 Pa m s")
same("N m", "5", "5 N m", "5 Nm", "5 N·m", "5 N*m", "5 J", "5000 N mm", "5000 mN m", "5 kg m^2/s^2", "5 kg m²/s²", "0.005 kNm", "5 W s", "5 newton metres")
same("N/m", "1600", "1600 N/m", "1.6 kN/m", "1.6 N/mm", "1600 kg/s^2", "1,6 kN/m", "1600 N m^-1", "1.6e3 N/m", "1600 J/m^2", "1.6 KN/m", "1600 N/m.")
same("N m/rad", "20", "20 N m/rad", "20 Nm/rad", "20 N m", "20 Nm", "20 J")
same("kg m^2", "0.4", "0.4 kg m^2", "0.4 kg m²", "0.4 kg·m²", "0.4 kgm^2", "0.4 kg m2", "4000 kg cm^2", "0.4 N m s^2", "400 g m²")
same("m/s", "2.5", "2.5 m/s", "2.5 m s^-1", "2.5 m·s⁻¹", "9 km/h", "2500 mm/s", "2.5 metres per second", "250 cm/s", "2.5 \\mathrm{m/s}", "5/2 m/s", "2,5 m/s")
same("m/s^2", "9.81", "9.81 m/s^2", "9.81 m/s²", "9,81 m/s2", "9.81 m s^-2", "9.81 m/(s s)", "981 cm/s^2", "9.81 N/kg", "9.81 metres per second squared")
same("s", "0.25", "0.25 s", "250 ms", "0,25 s", "1/4 s", "0.25 sec", "0.25 seconds", "2.5e-1 s", "T = 0.25 s", "0.25 1/Hz")
same("s", "90", "90 s", "1.5 min", "0.025 h", "90")
same("kg", "0.25", "250 g", "0.25 kg", "0,25 kg", "2.5e-4 t", "250 grams", "1/4 kg")
same("ohm", "4700", "4700 ohm", "4.7 kohm", "4.7 kΩ", "4700 Ω", "4,7 kΩ", "4.7e3 \\Omega", "4.7 kV/A")
same("F", "1e-6", "1 µF", "1 uF", "1e-6 F", "10^-6 F", "1000 nF", "0.001 mF")
same("Pa", "2e11", "200 GPa", "2e11 Pa", "2·10¹¹ Pa", "2e5 N/mm^2", "2e5 MPa", "2e11 N/m²")
same("J", "0.5", "0.5 J", "500 mJ", "0.5 N m", "0.5 W s", "1/2 J", "0.5 kg m^2/s^2")
same("W", "75", "75 W", "75 J/s", "0.075 kW", "75 N m/s", "75")
same("N", "9.81", "9.81 N", "9.81 kg m/s^2", "0.00981 kN", "2 * 4.905 N")
# Another dimension.
for asked, responses in {
    "rad/s": ["10 s", "10 m", "10 rad", "10 m/s", "10 1/s^2", "10 N", "5 kg"],
    "m": ["5 J", "5 N + 3 N", "5 m^2", "5 s", "5 N", "5 rad/s", "5 1/m", "5 kg m", "1/2 s"],
    "N s/m": ["100 N/m", "100 N s", "100 kg", "100 N m"],
    "N m": ["5 N", "5 N/m", "5 kg m", "5 W"],
    "1": ["5 m", "0.1 s", "3 Hz", "2 kg"],
    "s": ["3 Hz", "3 rad/s", "3 m"],
}.items():
    for response in responses:
        row(asked, response, "dimension")
# Two readings, the likelier first.
for response, value in {
    "162·10-3 m": 0.162, "5.0×10−3": 0.005, "162.10^-3 m": 0.162, "25.2*10-3 m": 0.0252, "25.2x10-3 m": 0.0252,
    "1.25×103 m": 1250, "1,234": 1.234, "1,250 m": 1.25, "12,500": 12.5,
}.items():
    row("m", response, value)
# Two meanings of one run of letters, slash or sign.
for asked, responses in {
    "m/s": ["2.5 ms^-1", "2.5 ms-1", "2.5 ms⁻¹", "9 kmh"],
    "m/s^2": ["5 ms^-2", "5 ms⁻²"],
    "rad/s": ["10 rads^-1", "ω <= 10", "ω ≥ 10", "ω != 10", "ω not = 10", "ω = 9; ω = 10", "ω = 9, ω = 10", "99 rad/s = 10 rad/s", "f (Hz) = 1.59", "f in Hz = 1.59", "f/Hz = 1.59", "ω² = 10", "sqrt(ω) = 10", "2ω = 20", "-ω = -10", "ω/2 = 5", "ω = 9 k = 10", "sin ω = 10", "10 = 2ω", "π:3", "10(1) rad/s"],
    "N s/m": ["6 N/m/s"],
    "rad": ["180°-10°", "18.7°-180°", "180° + 10", "60 grad", "66.67 grad"],
    "m": ["0.29 (2/7)", "0.(285714)", "7.78(1)", "100 1", "10 mm-5 mm", "3 m-2 m", "5 inch", "2*3 m * 4"],
    "1": ["2 cycles", "2 periods", "3 degrees of freedom"],
}.items():
    for response in responses:
        row(asked, response, "unreadable")
same("m", "5", "about 5")
same("m", "5", "5 m?")
# Not to be read, or only by guessing.
for response in [
    "m", "x", "a dozen", "1.2.3", "1,2,3", "1 2", "5 m 3", "5 mm 3 cm", "5 ± 0.1", "5 +/- 0.1 m", "4-5 m", "19-21", "2e", "2e m", "5e- m", "5 furlong", "5 N/m s", "5 J/kg·K",
    "5 kgs", "5 m)", "(5 m", "5 m^x", "5 m^0", "1/0", "1/0 m", "sqrt(-1) m", "5 i", "3 - 4i", "inf", "∞ m", "NaN", "1e999", "10^400 m", "5 m or 6 m", "5; 6", "[5, 6]", "3 1/2 m", "2**", "sqrt() m",
    "m 5", "5 m/", "5 per", "x = ", "=", "ln(0)", "pi pi pi m q", "5..6", "1 .. 2 m",
    "1{,}.796 m", "0.333sin 933333333333333333333333333333333", "sin(exp(700))",
]:
    row("m", response, "unreadable")

print("# Made by tests/references/typed_numbers.py: unit that is asked, response, SI value or why there is none.")
for asked, response, value in ROWS:
    text = value if isinstance(value, str) else format(value, ".20g")
    print(f"{asked}\t{response}\t{text}")
