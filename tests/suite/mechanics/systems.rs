//! Systems of the textbooks: what an author writes, and the equations that have to come out.

/// A system and its equations of motion, linearized about the equilibrium.
pub(super) struct System {
    pub(super) name: &'static str,
    /// Coordinates; one with a trailing `°` is an angle.
    pub(super) coordinates: &'static [&'static str],
    pub(super) kinematics: &'static [(&'static str, &'static str)],
    pub(super) kinetic: &'static str,
    pub(super) potential: &'static str,
    pub(super) dissipation: &'static str,
    pub(super) forces: &'static [(&'static str, &'static str)],
    /// One per coordinate.
    pub(super) equations: &'static [&'static str],
}

/// What most systems leave out.
const PLAIN: System = System {
    name: "",
    coordinates: &["x"],
    kinematics: &[],
    kinetic: "0",
    potential: "0",
    dissipation: "0",
    forces: &[],
    equations: &[],
};

pub(super) const SYSTEMS: &[System] = &[
    System {
        name: "bar pinned at one end, hanging block",
        coordinates: &["theta°"],
        kinematics: &[("x", "l*theta/2"), ("y", "l*theta")],
        kinetic: "1/2*(m*l^2/3)*theta'^2 + 1/2*(2*m)*x'^2",
        potential: "1/2*k*x^2 + 1/2*k*y^2",
        dissipation: "1/2*c*x'^2",
        equations: &["5/6*m*l^2*theta'' + 1/4*c*l^2*theta' + 5/4*k*l^2*theta = 0"],
        ..PLAIN
    },
    System {
        name: "bar pinned at its centre, block on a cable",
        coordinates: &["theta°"],
        kinetic: "1/2*(m_b*l^2/12)*theta'^2 + 1/2*m*(l*theta'/2)^2",
        potential: "1/2*k*(l*theta/2)^2*2",
        dissipation: "1/2*c*(l*theta'/2)^2",
        equations: &["l^2/4*((m_b/3 + m)*theta'' + c*theta' + 2*k*theta) = 0"],
        ..PLAIN
    },
    System {
        name: "two springs and a damper to the same wall",
        kinetic: "1/2*m*x'^2",
        potential: "1/2*(k1 + k2)*x^2",
        dissipation: "1/2*b*x'^2",
        equations: &["m*x'' + b*x' + (k1 + k2)*x = 0"],
        ..PLAIN
    },
    System {
        name: "disk on an incline, spring at the top of the rim",
        kinematics: &[("theta", "x/r")],
        kinetic: "1/2*m*x'^2 + 1/2*(m*r^2/2)*theta'^2",
        potential: "1/2*k*(2*x)^2 - m*g*x*sin(phi)",
        dissipation: "1/2*c*x'^2",
        equations: &["3/2*m*x'' + c*x' + 4*k*x = m*g*sin(phi)"],
        ..PLAIN
    },
    System {
        name: "stepped disk with a hanging block",
        coordinates: &["theta°"],
        kinematics: &[("x", "-r1*theta"), ("z1", "r1*theta"), ("z2", "-r2*theta")],
        kinetic: "1/2*I*theta'^2 + 1/2*m*x'^2",
        potential: "1/2*k1*z1^2 + 1/2*k2*z2^2 + m*g*x",
        equations: &["(I + m*r1^2)*theta'' + (k1*r1^2 + k2*r2^2)*theta = m*g*r1"],
        ..PLAIN
    },
    System {
        name: "springs in series",
        kinetic: "1/2*m*x'^2",
        potential: "1/2*(1/(1/k1 + 1/k2))*x^2",
        dissipation: "1/2*b*x'^2",
        equations: &["m*x'' + b*x' + k1*k2/(k1 + k2)*x = 0"],
        ..PLAIN
    },
    System {
        name: "rolling disk with springs at centre and top",
        coordinates: &["theta°"],
        kinetic: "1/2*(3/2*m*r^2)*theta'^2",
        potential: "1/2*3*k*(2*r*theta)^2 + 1/2*k*(r*theta)^2",
        dissipation: "1/2*c*(r*theta')^2",
        equations: &["3/2*m*r^2*theta'' + c*r^2*theta' + 13*k*r^2*theta = 0"],
        ..PLAIN
    },
    System {
        name: "vertical mass on a spring, from equilibrium",
        kinetic: "1/2*m*x'^2",
        potential: "1/2*k*(x + m*g/k)^2 - m*g*(x + m*g/k)",
        equations: &["m*x'' + k*x = 0"],
        ..PLAIN
    },
    System {
        name: "simple pendulum",
        coordinates: &["theta°"],
        kinematics: &[("x", "l*sin(theta)"), ("y", "-l*cos(theta)")],
        kinetic: "1/2*m*(x'^2 + y'^2)",
        potential: "m*g*y",
        equations: &["m*l^2*theta'' + m*g*l*theta = 0"],
        ..PLAIN
    },
    System {
        name: "compound pendulum",
        coordinates: &["theta°"],
        kinetic: "1/2*I*theta'^2",
        potential: "-m*g*d*cos(theta)",
        equations: &["I*theta'' + m*g*d*theta = 0"],
        ..PLAIN
    },
    System {
        name: "torsion pendulum",
        coordinates: &["theta°"],
        kinetic: "1/2*I*theta'^2",
        potential: "1/2*kappa*theta^2",
        equations: &["I*theta'' + kappa*theta = 0"],
        ..PLAIN
    },
    System {
        name: "circuit of coil and capacitor",
        coordinates: &["q"],
        kinetic: "1/2*L*q'^2",
        potential: "q^2/(2*C)",
        equations: &["L*q'' + q/C = 0"],
        ..PLAIN
    },
    System {
        name: "liquid column in a U-tube",
        kinetic: "1/2*rho*S*L*x'^2",
        potential: "rho*g*S*x^2",
        equations: &["rho*S*(L*x'' + 2*g*x) = 0"],
        ..PLAIN
    },
    System {
        name: "inverted pendulum between two springs",
        coordinates: &["theta°"],
        kinetic: "1/2*m*l^2*theta'^2",
        potential: "k*a^2*sin(theta)^2 + m*g*l*cos(theta)",
        equations: &["m*l^2*theta'' + (2*k*a^2 - m*g*l)*theta = 0"],
        ..PLAIN
    },
    System {
        name: "block with a pulley on its spring, sliding",
        kinematics: &[("z", "-2*x")],
        kinetic: "1/2*m*x'^2",
        potential: "1/2*k*x^2 + 1/2*k*z^2",
        equations: &["m*x'' + 5*k*x = 0"],
        ..PLAIN
    },
    System {
        name: "two blocks over a disk",
        kinematics: &[("y", "x"), ("theta", "x/r")],
        kinetic: "1/2*m*x'^2 + 1/2*m*y'^2 + 1/2*I*theta'^2",
        potential: "1/2*k*x^2 - m*g*y",
        equations: &["(2*m + I/r^2)*x'' + k*x = m*g"],
        ..PLAIN
    },
    System {
        name: "circuit with resistance",
        coordinates: &["q"],
        kinetic: "1/2*L*q'^2",
        potential: "q^2/(2*C)",
        dissipation: "1/2*R*q'^2",
        equations: &["L*q'' + R*q' + q/C = 0"],
        ..PLAIN
    },
    System {
        name: "disk rolling under a harmonic moment on its hub",
        kinetic: "1/2*m*x'^2 + 1/2*(1/2*m*r^2)*(x'/r)^2",
        potential: "1/2*k*x^2 + 1/2*(2*k)*(3*x/2)^2",
        dissipation: "1/2*b*x'^2",
        forces: &[("x", "-M0/r*sin(Omega*t)")],
        equations: &["3/2*m*x'' + b*x' + 11/2*k*x = -M0*sin(Omega*t)/r"],
        ..PLAIN
    },
    System {
        name: "bar pinned at its centre under a harmonic force",
        coordinates: &["theta°"],
        kinetic: "1/2*(m*L^2/12)*theta'^2",
        potential: "1/2*k*(L*theta/2)^2",
        dissipation: "1/2*c*(L*theta'/2)^2",
        forces: &[("theta", "F0*L/2*sin(Omega*t)")],
        equations: &["m*L^2/12*theta'' + c*L^2/4*theta' + k*L^2/4*theta = F0*L/2*sin(Omega*t)"],
        ..PLAIN
    },
    System {
        name: "block on a moving base, relative motion",
        coordinates: &["z"],
        kinematics: &[("u", "U*sin(Omega*t)"), ("x", "z + u")],
        kinetic: "1/2*m*x'^2",
        potential: "1/2*(2*k1*k2/(2*k1 + k2))*z^2",
        dissipation: "1/2*b*z'^2",
        equations: &["m*z'' + b*z' + 2*k1*k2/(2*k1 + k2)*z = m*U*Omega^2*sin(Omega*t)"],
        ..PLAIN
    },
    System {
        name: "block on a moving base, absolute motion",
        kinematics: &[("u", "U*sin(Omega*t)")],
        kinetic: "1/2*m*x'^2",
        potential: "1/2*k*(x - u)^2",
        dissipation: "1/2*c*(x' - u')^2",
        equations: &["m*x'' + c*x' + k*x = k*U*sin(Omega*t) + c*U*Omega*cos(Omega*t)"],
        ..PLAIN
    },
    System {
        name: "machine with a rotating unbalance",
        kinematics: &[("X", "x + ecc*sin(Omega*t)"), ("Y", "-ecc*cos(Omega*t)")],
        kinetic: "1/2*(m - mu)*x'^2 + 1/2*mu*(X'^2 + Y'^2)",
        potential: "1/2*k*x^2",
        dissipation: "1/2*c*x'^2",
        equations: &["m*x'' + c*x' + k*x = mu*ecc*Omega^2*sin(Omega*t)"],
        ..PLAIN
    },
    System {
        name: "harmonic force on a damped block",
        kinetic: "1/2*m*x'^2",
        potential: "1/2*k*x^2",
        dissipation: "1/2*alpha*x'^2",
        forces: &[("x", "F0*cos(Omega*t)")],
        equations: &["m*x'' + alpha*x' + k*x = F0*cos(Omega*t)"],
        ..PLAIN
    },
    System {
        name: "vibration absorber",
        coordinates: &["x1", "x2"],
        kinetic: "1/2*m1*x1'^2 + 1/2*m2*x2'^2",
        potential: "1/2*k1*x1^2 + 1/2*k2*(x2 - x1)^2",
        forces: &[("x1", "F0*cos(Omega*t)")],
        equations: &[
            "m1*x1'' + (k1 + k2)*x1 - k2*x2 = F0*cos(Omega*t)",
            "m2*x2'' - k2*x1 + k2*x2 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "driven circuit",
        coordinates: &["q"],
        kinetic: "1/2*Lh*q'^2",
        potential: "1/2*q^2/Cap",
        dissipation: "1/2*R*q'^2",
        forces: &[("q", "E0*cos(Omega*t)")],
        equations: &["Lh*q'' + R*q' + q/Cap = E0*cos(Omega*t)"],
        ..PLAIN
    },
    System {
        name: "block and disk with two dampers",
        coordinates: &["x1", "theta°"],
        kinematics: &[("x2", "-r2*theta"), ("x3", "-r1*theta"), ("z", "x3 - x1")],
        kinetic: "1/2*m1*x1'^2 + 1/2*m2*x2'^2 + 1/2*J*theta'^2",
        potential: "1/2*k1*z^2 + 1/2*k2*x2^2",
        dissipation: "1/2*b1*x1'^2 + 1/2*b2*x2'^2",
        equations: &[
            "m1*x1'' + b1*x1' + k1*x1 + k1*r1*theta = 0",
            "(J + m2*r2^2)*theta'' + b2*r2^2*theta' + (k1*r1^2 + k2*r2^2)*theta + k1*r1*x1 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "block, disk and hanging block",
        coordinates: &["x1", "x2"],
        kinetic: "1/2*(2*m)*x1'^2 + 1/2*m*x2'^2 + 1/2*J*(x2'/r)^2",
        potential: "1/2*k*x1^2 + 1/2*k*(x2 - x1)^2 - m*g*x2",
        equations: &[
            "2*m*x1'' + 2*k*x1 - k*x2 = 0",
            "(m + J/r^2)*x2'' - k*x1 + k*x2 = m*g",
        ],
        ..PLAIN
    },
    System {
        name: "three blocks in a chain",
        coordinates: &["x1", "x2", "x3"],
        kinetic: "1/2*m1*x1'^2 + 1/2*m2*x2'^2 + 1/2*m3*x3'^2",
        potential: "1/2*k1*x1^2 + 1/2*k2*(x2 - x1)^2 + 1/2*(2*k3)*(x3 - x2)^2",
        equations: &[
            "m1*x1'' + (k1 + k2)*x1 - k2*x2 = 0",
            "m2*x2'' - k2*x1 + (k2 + 2*k3)*x2 - 2*k3*x3 = 0",
            "m3*x3'' - 2*k3*x2 + 2*k3*x3 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "block on a table and hanging block",
        coordinates: &["x1", "x2"],
        kinetic: "1/2*(4*m)*x1'^2 + 1/2*(2*m)*x2'^2",
        potential: "1/2*(2*k)*x1^2 + 1/2*k*(x2 - x1)^2",
        equations: &["4*m*x1'' + 3*k*x1 - k*x2 = 0", "2*m*x2'' - k*x1 + k*x2 = 0"],
        ..PLAIN
    },
    System {
        name: "three masses between walls, absolute",
        coordinates: &["x1", "x2", "x3"],
        kinetic: "1/2*m1*x1'^2 + 1/2*m2*x2'^2 + 1/2*m3*x3'^2",
        potential: "1/2*k1*x1^2 + 1/2*k2*(x2 - x1)^2 + 1/2*k1*x2^2 + 1/2*k2*(x3 - x2)^2",
        equations: &[
            "m1*x1'' + (k1 + k2)*x1 - k2*x2 = 0",
            "m2*x2'' - k2*x1 + (k1 + 2*k2)*x2 - k2*x3 = 0",
            "m3*x3'' - k2*x2 + k2*x3 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "three masses between walls, with a relative coordinate",
        coordinates: &["x1", "x2", "z"],
        kinematics: &[("x3", "x2 + z")],
        kinetic: "1/2*m1*x1'^2 + 1/2*m2*x2'^2 + 1/2*m3*x3'^2",
        potential: "1/2*k1*x1^2 + 1/2*k2*(x2 - x1)^2 + 1/2*k1*x2^2 + 1/2*k2*(x3 - x2)^2",
        equations: &[
            "m1*x1'' + (k1 + k2)*x1 - k2*x2 = 0",
            "(m2 + m3)*x2'' + m3*z'' - k2*x1 + (k1 + k2)*x2 = 0",
            "m3*x2'' + m3*z'' + k2*z = 0",
        ],
        ..PLAIN
    },
    System {
        name: "two blocks, force on the first",
        coordinates: &["x1", "x2"],
        kinetic: "1/2*(2*m)*x1'^2 + 1/2*m*x2'^2",
        potential: "1/2*k*x1^2 + 1/2*k*(x2 - x1)^2 + 1/2*(2*k)*x2^2",
        forces: &[("x1", "f0*sin(Omega*t)")],
        equations: &[
            "2*m*x1'' + 2*k*x1 - k*x2 = f0*sin(Omega*t)",
            "m*x2'' - k*x1 + 3*k*x2 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "disk that unwinds its cord, pushing a block",
        coordinates: &["x1", "x2"],
        kinematics: &[("theta", "-x1/r"), ("z", "r*theta - x2")],
        kinetic: "1/2*m*x1'^2 + 1/2*(1/2*m*r^2)*theta'^2 + 1/2*m*x2'^2",
        potential: "1/2*k*x1^2 + 1/2*k*z^2",
        equations: &["3/2*m*x1'' + 2*k*x1 + k*x2 = 0", "m*x2'' + k*x1 + k*x2 = 0"],
        ..PLAIN
    },
    System {
        name: "stepped pulley between two blocks",
        coordinates: &["x1", "x2"],
        kinematics: &[("theta", "2*x1/r"), ("z", "x2 - r*theta")],
        kinetic: "1/2*m*x1'^2 + 1/2*(1/2*m*r^2)*theta'^2 + 1/2*m*x2'^2",
        potential: "1/2*k*x1^2 + 1/2*k*z^2",
        equations: &[
            "3*m*x1'' + 5*k*x1 - 2*k*x2 = 0",
            "m*x2'' - 2*k*x1 + k*x2 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "coupling by a spring, damped",
        coordinates: &["x1", "x2"],
        kinetic: "1/2*m1*x1'^2 + 1/2*m2*x2'^2",
        potential: "1/2*k1*x1^2 + 1/2*k2*x2^2 + 1/2*kc*(x1 - x2)^2",
        dissipation: "1/2*alpha1*x1'^2 + 1/2*alpha2*x2'^2",
        equations: &[
            "m1*x1'' + alpha1*x1' + (k1 + kc)*x1 - kc*x2 = 0",
            "m2*x2'' + alpha2*x2' + (k2 + kc)*x2 - kc*x1 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "coupling by a mass",
        coordinates: &["x1", "x2"],
        kinematics: &[("xc", "(x1 + x2)/2")],
        kinetic: "1/2*m1*x1'^2 + 1/2*m2*x2'^2 + 1/2*Mc*xc'^2",
        potential: "1/2*k1*x1^2 + 1/2*k2*x2^2",
        dissipation: "1/2*alpha1*x1'^2 + 1/2*alpha2*x2'^2",
        equations: &[
            "(m1 + Mc/4)*x1'' + Mc/4*x2'' + alpha1*x1' + k1*x1 = 0",
            "(m2 + Mc/4)*x2'' + Mc/4*x1'' + alpha2*x2' + k2*x2 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "coupling by a damper",
        coordinates: &["x1", "x2"],
        kinetic: "1/2*m1*x1'^2 + 1/2*m2*x2'^2",
        potential: "1/2*k1*x1^2 + 1/2*k2*x2^2",
        dissipation: "1/2*alpha1*x1'^2 + 1/2*alpha2*x2'^2 + 1/2*beta*(x1' - x2')^2",
        equations: &[
            "m1*x1'' + (alpha1 + beta)*x1' - beta*x2' + k1*x1 = 0",
            "m2*x2'' + (alpha2 + beta)*x2' - beta*x1' + k2*x2 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "pendulums coupled by a spring",
        coordinates: &["th1°", "th2°"],
        kinetic: "1/2*m1*(l1*th1')^2 + 1/2*m2*(l2*th2')^2",
        potential: "-m1*g*l1*cos(th1) - m2*g*l2*cos(th2) + 1/2*K*(s*(sin(th1) - sin(th2)))^2",
        equations: &[
            "m1*l1^2*th1'' + (K*s^2 + m1*g*l1)*th1 - K*s^2*th2 = 0",
            "m2*l2^2*th2'' + (K*s^2 + m2*g*l2)*th2 - K*s^2*th1 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "free carts",
        coordinates: &["x1", "x2"],
        kinetic: "1/2*m1*x1'^2 + 1/2*m2*x2'^2",
        potential: "1/2*k*(x2 - x1)^2",
        equations: &["m1*x1'' + k*x1 - k*x2 = 0", "m2*x2'' - k*x1 + k*x2 = 0"],
        ..PLAIN
    },
    System {
        name: "double pendulum",
        coordinates: &["th1°", "th2°"],
        kinematics: &[
            ("xa", "l1*sin(th1)"),
            ("ya", "-l1*cos(th1)"),
            ("xb", "xa + l2*sin(th2)"),
            ("yb", "ya - l2*cos(th2)"),
        ],
        kinetic: "1/2*m1*(xa'^2 + ya'^2) + 1/2*m2*(xb'^2 + yb'^2)",
        potential: "m1*g*ya + m2*g*yb",
        equations: &[
            "(m1 + m2)*l1^2*th1'' + m2*l1*l2*th2'' + (m1 + m2)*g*l1*th1 = 0",
            "m2*l1*l2*th1'' + m2*l2^2*th2'' + m2*g*l2*th2 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "Rayleigh damping",
        coordinates: &["x1", "x2"],
        kinetic: "1/2*m1*x1'^2 + 1/2*m2*x2'^2",
        potential: "1/2*k1*x1^2 + 1/2*k2*(x2 - x1)^2",
        dissipation: "1/2*a0*(m1*x1'^2 + m2*x2'^2) + 1/2*a1*(k1*x1'^2 + k2*(x2' - x1')^2)",
        equations: &[
            "m1*x1'' + (a0*m1 + a1*(k1 + k2))*x1' - a1*k2*x2' + (k1 + k2)*x1 - k2*x2 = 0",
            "m2*x2'' - a1*k2*x1' + (a0*m2 + a1*k2)*x2' - k2*x1 + k2*x2 = 0",
        ],
        ..PLAIN
    },
    System {
        name: "three beads on a ring",
        coordinates: &["x1", "x2", "x3"],
        kinetic: "1/2*m*(x1'^2 + x2'^2 + x3'^2)",
        potential: "1/2*k*((x2 - x1)^2 + (x3 - x2)^2 + (x1 - x3)^2)",
        equations: &[
            "m*x1'' + 2*k*x1 - k*x2 - k*x3 = 0",
            "m*x2'' - k*x1 + 2*k*x2 - k*x3 = 0",
            "m*x3'' - k*x1 - k*x2 + 2*k*x3 = 0",
        ],
        ..PLAIN
    },
];
