"""Prints the reference values of `crates/formula/src/expr/program/references.rs`: formulas to 36 digits, by mpmath."""

from mpmath import *

mp.dps = 60
a, b, x, t = mpf("0.3"), mpf("0.1"), mpf("-2.5"), mpf("1.75")
i, pi_, e_ = mpc(0, 1), pi, e
abs_ = abs

REAL = """
sqrt(a) exp(x) ln(b) log10(t) sin(1e6*t) cos(t) tan(x) asin(a) acos(x/3) atan(x) sinh(a) sinh(20*t) cosh(x) tanh(b)
asinh(x) acosh(t) atanh(a) atan2(b,x) atan2(-b,x) hypot(a,x) elliptic_k(a) elliptic_k(1-1e-9) elliptic_k(x)
a^b t^x (a/b)^(1/3) x^7 x^-5 t^100 exp(-x^2)*cos(100*t) sqrt(t^2-a^2)/(2*pi) ln(1+1e-12*a) sin(pi*t)
(1-cos(1e-6*a))/1e-12 sqrt(1+b)-sqrt(1-b) exp(b)-1-b-b^2/2 (a+b)^9-a^9 1/(x+2.4999999999) sin(1e12*b)
a*cos(40*t)+b*sin(40*t) abs(3+4*i) arg(a-i*b) re(exp(i*t)) im(sqrt(x+i*a)) abs(1/(1-t^2+2*i*a*t))
re(asin(t+i*a)) im(acos(t+i*a)) re(atan(x+i*b)) im(tanh(a+i*b)) re(ln(x-i*b)) im((a+i*b)^(t+i*x)) re((a+i*b)^-7)
im(acosh(x+i*a)) re(asinh(x+i*b)) im(log10(x+i*a)) re(cosh(a+i*t)) im(cos(a+i*t)) re(tan(t+i*a)) im(atanh(t+i*b))
""".split()


def value(formula):
    python = formula.replace("^", "**")
    scope = {
        "mpf": mpf, "ln": log, "elliptic_k": ellipk, "abs": fabs, "atan2": atan2, "hypot": hypot, "re": re, "im": im, "arg": arg,
        "a": a, "b": b, "x": x, "t": t, "i": i, "pi": pi, "sqrt": sqrt, "exp": exp, "log10": log10, "sin": sin,
        "cos": cos, "tan": tan, "asin": asin, "acos": acos, "atan": atan, "sinh": sinh, "cosh": cosh, "tanh": tanh,
        "asinh": asinh, "acosh": acosh, "atanh": atanh,
    }
    import re as regex
    python = regex.sub(r"(?<![A-Za-z_0-9.])(\d+(?:\.\d+)?(?:e-?\d+)?)", r"mpf('\1')", python)
    python = regex.sub(r"(log|atan)mpf\('(\d+)'\)", r"\1\2", python)
    return eval(python, scope)


for formula in REAL:
    print(f'    ("{formula}", "{nstr(value(formula), 36, strip_zeros=False)}"),')
