//! Elementary functions of long numbers: arguments are made small, then series are summed.

use super::{BITS, Long};

const LN_2: Long = Long {
    is_negative: false,
    words: [
        0x8a0d_175b_8baa_fa2b,
        0x40f3_4326_7298_b62d,
        0xc9e3_b398_03f2_f6af,
        0xb172_17f7_d1cf_79ab,
    ],
    exponent: -256,
};

/// π/2 as a sum of three parts of 192 bits, whose products with numbers of 53 bits are exact.
const HALF_PI: [Long; 3] = [
    Long {
        is_negative: false,
        words: [
            0,
            0x2902_4e08_8a67_cc74,
            0xc4c6_628b_80dc_1cd1,
            0xc90f_daa2_2168_c234,
        ],
        exponent: -255,
    },
    Long {
        is_negative: false,
        words: [
            0,
            0xe546_6cf3_4e90_c6cc,
            0x5282_1e63_8d01_377b,
            0x82ef_a98e_c4e6_c894,
        ],
        exponent: -453,
    },
    Long {
        is_negative: false,
        words: [
            0,
            0x16d5_d989_79fb_1bd1,
            0x84d5_b5b5_4709_1792,
            0xac29_b7c9_7c50_dd3f,
        ],
        exponent: -649,
    },
];

/// Halvings of the argument of an exponential before its series.
const HALVINGS: i32 = 8;

/// Beyond this an exponential leaves the range of binary64 by far, and is taken there.
const LARGEST_EXPONENT: f64 = 1e5;

fn one() -> Long {
    Long::from(1.0)
}

/// Sums `first · (1 + f₁ (1 + f₂ (…)))`, `factor(term, n)` giving the term after, until terms no longer count.
fn series(first: Long, factor: impl Fn(Long, u64) -> Long) -> Long {
    let (mut sum, mut term) = (first, first);
    for n in 1.. {
        term = factor(term, n);
        if term.is_zero() || term.magnitude() < sum.magnitude() - BITS {
            break;
        }
        sum = sum + term;
    }
    sum
}

impl Long {
    /// Exponential.
    #[must_use]
    pub fn exp(self) -> Self {
        let rounded = self.to_f64().clamp(-LARGEST_EXPONENT, LARGEST_EXPONENT);
        let turns = (rounded / std::f64::consts::LN_2).round();
        if self.abs() > Self::from(LARGEST_EXPONENT) {
            return one().shifted(turns as i32);
        }
        let rest = self - LN_2 * Self::from(turns);
        let mut power = rest.shifted(-HALVINGS).short_expm1();
        // (1 + p)² - 1 keeps the digits of small powers.
        for _ in 0..HALVINGS {
            power = power.shifted(1) + power * power;
        }
        (one() + power).shifted(turns as i32)
    }

    /// e^x − 1 by its series.
    fn short_expm1(self) -> Self {
        series(self, |term, n| (term * self).over(n + 1))
    }

    /// The natural logarithm of a positive number.
    #[must_use]
    pub fn ln(self) -> Self {
        let mut exponent = self.magnitude();
        let mut mantissa = self.shifted(-exponent);
        if mantissa.to_f64() > std::f64::consts::SQRT_2 {
            mantissa = mantissa.shifted(-1);
            exponent += 1;
        }
        let fraction = ((mantissa - one()) / (mantissa + one()))
            .short_atanh()
            .shifted(1);
        LN_2 * Self::from(f64::from(exponent)) + fraction
    }

    /// Decimal logarithm of a positive number.
    #[must_use]
    pub fn log10(self) -> Self {
        self.ln() / Self::from(10.0).ln()
    }

    /// Its series, for numbers up to 1/2.
    fn short_atanh(self) -> Self {
        self.odd_series(self * self)
    }

    /// `x + x q/3 + x q²/5 + …`.
    fn odd_series(self, q: Self) -> Self {
        let mut sum = self;
        let mut power = self;
        for n in 1.. {
            power = power * q;
            let term = power.over(2 * n + 1);
            if term.is_zero() || term.magnitude() < sum.magnitude() - BITS {
                break;
            }
            sum = sum + term;
        }
        sum
    }

    /// What is left of an angle without the nearest multiple of a right angle, and that multiple modulo four.
    fn reduced(self) -> (Self, i32) {
        let turns = (self.to_f64() / std::f64::consts::FRAC_PI_2).round();
        let rest = HALF_PI
            .into_iter()
            .fold(self, |rest, part| rest - part * Self::from(turns));
        (rest, turns.rem_euclid(4.0) as i32)
    }

    /// Sine.
    #[must_use]
    pub fn sin(self) -> Self {
        let (rest, quarter) = self.reduced();
        let value = if quarter % 2 == 0 {
            rest.short_sin()
        } else {
            rest.short_cos()
        };
        if quarter < 2 { value } else { -value }
    }

    /// Cosine.
    #[must_use]
    pub fn cos(self) -> Self {
        let (rest, quarter) = self.reduced();
        let value = if quarter % 2 == 0 {
            rest.short_cos()
        } else {
            rest.short_sin()
        };
        if quarter == 0 || quarter == 3 {
            value
        } else {
            -value
        }
    }

    /// Tangent.
    #[must_use]
    pub fn tan(self) -> Self {
        self.sin() / self.cos()
    }

    fn short_sin(self) -> Self {
        let square = -(self * self);
        series(self, |term, n| (term * square).over(2 * n * (2 * n + 1)))
    }

    fn short_cos(self) -> Self {
        let square = -(self * self);
        series(one(), |term, n| (term * square).over(2 * n * (2 * n - 1)))
    }

    /// Inverse tangent.
    #[must_use]
    pub fn atan(self) -> Self {
        if self.abs() > one() {
            let right_angle = Self::PI.shifted(-1);
            let right_angle = if self.is_negative {
                -right_angle
            } else {
                right_angle
            };
            return right_angle - (one() / self).atan();
        }
        const HALVINGS: i32 = 3;
        let halved = (0..HALVINGS).fold(self, |x, _| x / (one() + (one() + x * x).sqrt()));
        halved.odd_series(-(halved * halved)).shifted(HALVINGS)
    }

    /// Angle of the point (x, y), called on y.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let right_angle = Self::PI.shifted(-1);
        if self.abs() > x.abs() {
            let angle = right_angle - (x / self.abs()).atan();
            return if self.is_negative { -angle } else { angle };
        }
        if x.is_zero() {
            return Self::ZERO;
        }
        let angle = (self / x).atan();
        match (x.is_negative, self.is_negative) {
            (false, _) => angle,
            (true, false) => angle + Self::PI,
            (true, true) => angle - Self::PI,
        }
    }

    /// `√(1 − x²)`.
    fn leg(self) -> Self {
        ((one() - self) * (one() + self)).sqrt()
    }

    /// Inverse sine, of numbers up to one in size.
    #[must_use]
    pub fn asin(self) -> Self {
        self.atan2(self.leg())
    }

    /// Inverse cosine, of numbers up to one in size.
    #[must_use]
    pub fn acos(self) -> Self {
        self.leg().atan2(self)
    }

    /// Hyperbolic sine.
    #[must_use]
    pub fn sinh(self) -> Self {
        if self.abs() < one() {
            let square = self * self;
            return series(self, |term, n| (term * square).over(2 * n * (2 * n + 1)));
        }
        let power = self.exp();
        (power - one() / power).shifted(-1)
    }

    /// Hyperbolic cosine.
    #[must_use]
    pub fn cosh(self) -> Self {
        let power = self.exp();
        (power + one() / power).shifted(-1)
    }

    /// Hyperbolic tangent.
    #[must_use]
    pub fn tanh(self) -> Self {
        // Beyond, it is ±1 to the last bit.
        const FLAT: f64 = 100.0;
        let rounded = self.to_f64();
        if rounded.abs() > FLAT {
            return Self::from(rounded.signum());
        }
        self.sinh() / self.cosh()
    }

    /// Inverse hyperbolic sine.
    #[must_use]
    pub fn asinh(self) -> Self {
        let root = (one() + self * self).sqrt();
        if self.abs() < Self::from(0.5) {
            return (self / root).short_atanh();
        }
        let size = (self.abs() + root).ln();
        if self.is_negative { -size } else { size }
    }

    /// Inverse hyperbolic cosine, of numbers from one up.
    #[must_use]
    pub fn acosh(self) -> Self {
        let root = ((self - one()) * (self + one())).sqrt();
        if self < Self::from(1.5) {
            return (root / self).atanh();
        }
        (self + root).ln()
    }

    /// Inverse hyperbolic tangent, of numbers below one in size.
    #[must_use]
    pub fn atanh(self) -> Self {
        if self.abs() < Self::from(0.5) {
            return self.short_atanh();
        }
        ((one() + self) / (one() - self)).ln().shifted(-1)
    }

    /// Length of a vector.
    #[must_use]
    pub fn hypot(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }

    /// The power of a positive number.
    #[must_use]
    pub fn pow(self, exponent: Self) -> Self {
        (self.ln() * exponent).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A decimal, to the last bits.
    fn decimal(text: &str) -> Long {
        let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
        let digits = mantissa.trim_start_matches('-').replace('.', "");
        let decimals = mantissa.split_once('.').map_or(0, |(_, part)| part.len());
        let whole = digits.bytes().fold(Long::ZERO, |sum, digit| {
            sum * Long::from(10.0) + Long::from(f64::from(digit - b'0'))
        });
        let power = power.parse::<i32>().unwrap() - decimals as i32;
        let value = whole * Long::from(10.0).powi(power);
        if mantissa.starts_with('-') {
            -value
        } else {
            value
        }
    }

    fn assert_near(name: &str, found: Long, expected: &str) {
        let expected = decimal(expected);
        let error = ((found - expected) / expected).abs();
        assert!(error.to_f64() < 1e-70, "{name}: {:e}", error.to_f64());
    }

    /// Values to 74 digits by mpmath: `nstr(f(x), 74)`.
    #[test]
    fn functions_agree_to_seventy_digits() {
        for (name, of, x, expected) in VALUES {
            assert_near(name, of(Long::from(*x)), expected);
        }
    }

    #[test]
    fn roundings_and_conversions() {
        for x in [0.0, 1.0, -2.5, 1e-300, 5e-324, 1.797e308, 0.1] {
            assert_eq!(Long::from(x).to_f64(), x);
        }
        for (x, floor) in [
            (2.5, 2.0),
            (-2.5, -3.0),
            (0.3, 0.0),
            (-0.3, -1.0),
            (4.0, 4.0),
            (-4.0, -4.0),
        ] {
            assert_eq!(Long::from(x).floor().to_f64(), floor, "{x}");
        }
        let third = Long::from(1.0) / Long::from(3.0);
        assert!((third * Long::from(3.0) - Long::from(1.0)).abs().to_f64() < 1e-75);
        let tiny = (Long::from(1.0) + Long::from(1e-60)) - Long::from(1.0);
        assert!((tiny.to_f64() / 1e-60 - 1.0).abs() < 1e-15);
    }

    const VALUES: &[(&str, fn(Long) -> Long, f64, &str)] = &[
        (
            "exp",
            Long::exp,
            1.0,
            "2.7182818284590452353602874713526624977572470936999595749669676277240766304",
        ),
        (
            "exp",
            Long::exp,
            -2.5,
            "0.08208499862389879516952867446715980783780412101543664884575841051522475688",
        ),
        (
            "exp",
            Long::exp,
            1e-20,
            "1.0000000000000000000099999999999999994515827145420957165118105308399615485",
        ),
        (
            "exp",
            Long::exp,
            300.25,
            "2.4941248615349212861016143149068194319534538911968655233944294799923214326e+130",
        ),
        (
            "exp",
            Long::exp,
            -700.0,
            "9.8596765437597708567053729478494651051156001814009417105864667677931867966e-305",
        ),
        (
            "ln",
            Long::ln,
            2.0,
            "0.69314718055994530941723212145817656807550013436025525412068000949339362197",
        ),
        (
            "ln",
            Long::ln,
            0.75,
            "-0.28768207245178092743921900599382743150350971089776105650666568534929295072",
        ),
        (
            "ln",
            Long::ln,
            1.0000000001,
            "1.0000000826903709908196694080357637786121654138771523974618597008731224918e-10",
        ),
        (
            "ln",
            Long::ln,
            1e-300,
            "-690.77552789821370518033834457010050290861334158364134406254720179008713545",
        ),
        (
            "ln",
            Long::ln,
            3e+200,
            "461.61563088747724646472665838630572842630034605761552654541506310821232227",
        ),
        (
            "log10",
            Long::log10,
            3.0,
            "0.47712125471966243729502790325511530920012886419069586482986564030522915278",
        ),
        (
            "log10",
            Long::log10,
            0.2,
            "-0.69897000433601878067807444144332987436472859683776035144409519037574800897",
        ),
        (
            "sin",
            Long::sin,
            1.0,
            "0.84147098480789650665250232163029899962256306079837106567275170999191040439",
        ),
        (
            "sin",
            Long::sin,
            -2.5,
            "-0.59847214410395649405185470218616227170359717157722357330262703263874427219",
        ),
        (
            "sin",
            Long::sin,
            1e-09,
            "1.0000000000000000621149247911131897210979396305627153032367124566569194966e-9",
        ),
        (
            "sin",
            Long::sin,
            1000000000.0,
            "0.54584344944869956424438727089751452899502293026289220767173642387921187105",
        ),
        (
            "sin",
            Long::sin,
            3.141592653589793,
            "1.22464679914735317722606593227499799708305390129979194948825771626086961e-16",
        ),
        (
            "sin",
            Long::sin,
            1000000000000000.0,
            "0.85827279317023583552388639084840664660020340822072970781534177178773632653",
        ),
        (
            "cos",
            Long::cos,
            1.0,
            "0.54030230586813971740093660744297660373231042061792222767009725538110039477",
        ),
        (
            "cos",
            Long::cos,
            -2.5,
            "-0.80114361554693371483350279046735166442856784876782013507459799166202407717",
        ),
        (
            "cos",
            Long::cos,
            1e-09,
            "0.99999999999999999949999999999999993776007520888680831865015707105671906557",
        ),
        (
            "cos",
            Long::cos,
            1.5707963267948966,
            "6.1232339957367658861303296613750014646403777988362830520960549827724863084e-17",
        ),
        (
            "cos",
            Long::cos,
            1000000000000.0,
            "0.79144630185289027005376621411433230398676030743718665943909867712240495472",
        ),
        (
            "tan",
            Long::tan,
            0.3,
            "0.30933624960962322087071306352174169399259126573109728331223373463188959149",
        ),
        (
            "tan",
            Long::tan,
            1.57,
            "1255.7655915007896474570517687712058087268345857767401209002787396498569298",
        ),
        (
            "atan",
            Long::atan,
            0.1,
            "0.099668652491162032874599707131270787339496352931787600152193665279438442817",
        ),
        (
            "atan",
            Long::atan,
            -1.0,
            "-0.78539816339744830961566084581987572104929234984377645524373614807695410157",
        ),
        (
            "atan",
            Long::atan,
            7.5,
            "1.4382447944982225979614042479354815855386179699976727094736870685116936689",
        ),
        (
            "atan",
            Long::atan,
            1e-30,
            "1.0000000000000000833364206075859853509313360268686545023645094502155291821e-30",
        ),
        (
            "asin",
            Long::asin,
            0.3,
            "0.30469265401539749633370334028656419508642774258653867905814266902319799258",
        ),
        (
            "asin",
            Long::asin,
            -0.999999999,
            "-1.5707516054359752998749317572822751892952148721875535731340076985032800994",
        ),
        (
            "asin",
            Long::asin,
            1e-08,
            "1.0000000000000000375892274967951411381213422623782815277676354414943677633e-8",
        ),
        (
            "acos",
            Long::acos,
            0.3,
            "1.2661036727794991228976183513531872470121569571010142314293296271307102106",
        ),
        (
            "acos",
            Long::acos,
            -0.9,
            "2.6905658417935308568585247383601647028413926499544846081233582736234145729",
        ),
        (
            "acos",
            Long::acos,
            0.9999999999,
            "1.4142136208911563644242213387204832465959979878387669680408559521537803219e-5",
        ),
        (
            "sinh",
            Long::sinh,
            0.3,
            "0.30452029344714260735284639787199102363270269738714080193312681604651226478",
        ),
        (
            "sinh",
            Long::sinh,
            -2.5,
            "-6.0502044810397873214503236383504031876724818345238623313573199656614801846",
        ),
        (
            "sinh",
            Long::sinh,
            1e-12,
            "9.9999999999999997988664779592228203391950011612001229382284966086473288304e-13",
        ),
        (
            "cosh",
            Long::cosh,
            0.3,
            "1.0453385141288604816444546338166430085090501001266393958371733418062101812",
        ),
        (
            "cosh",
            Long::cosh,
            -2.5,
            "6.1322894796636861166198523128175629955102859555392989802030783761767049415",
        ),
        (
            "tanh",
            Long::tanh,
            0.3,
            "0.29131261245159089565816001576939894826172203912786264698219293371059979681",
        ),
        (
            "tanh",
            Long::tanh,
            -2.5,
            "-0.98661429815143028888127603923734963921251198218540693946157551388023183217",
        ),
        (
            "tanh",
            Long::tanh,
            1e-09,
            "1.000000000000000061948258124446523023415477235006118526495419006541406689e-9",
        ),
        (
            "asinh",
            Long::asinh,
            0.3,
            "0.29567304756342242846870257529647131928035243148764181840901392471154414394",
        ),
        (
            "asinh",
            Long::asinh,
            -2.5,
            "-1.6472311463710957106248586104436196635044144301932365282203100930843983758",
        ),
        (
            "asinh",
            Long::asinh,
            1e-12,
            "9.9999999999999997988664746258894870058618689613911637154041119440426590726e-13",
        ),
        (
            "asinh",
            Long::asinh,
            1e+20,
            "46.744849040440858989777061215145460720097554906935714774787238028844845816",
        ),
        (
            "acosh",
            Long::acosh,
            1.0000000001,
            "1.4142136208675861354593558234960067843006275524602051963252623953416680173e-5",
        ),
        (
            "acosh",
            Long::acosh,
            1.7,
            "1.1232309825872958572284089795448012302296288488361089394820189990863175824",
        ),
        (
            "acosh",
            Long::acosh,
            1e+30,
            "69.770699970381315849841600600645102598409392306175870139959667538644777661",
        ),
        (
            "atanh",
            Long::atanh,
            0.3,
            "0.30951960420311170327381433120220640065957373850145758940822781261425858455",
        ),
        (
            "atanh",
            Long::atanh,
            -0.9999999,
            "-8.4056213910223098608979082991407345997308370474091435493434732307420902932",
        ),
        (
            "atanh",
            Long::atanh,
            1e-09,
            "1.0000000000000000626149247911131898147119934838991724765735146357924381585e-9",
        ),
        (
            "sqrt",
            Long::sqrt,
            2.0,
            "1.4142135623730950488016887242096980785696718753769480731766797379907324785",
        ),
        (
            "sqrt",
            Long::sqrt,
            3e-301,
            "5.4772255750516611275285553980817898682333964249581386490398933703990134934e-151",
        ),
        (
            "sqrt",
            Long::sqrt,
            1e+200,
            "9.999999999999999848665611062551807152267652623733019560201176074481550763e+99",
        ),
    ];
}
