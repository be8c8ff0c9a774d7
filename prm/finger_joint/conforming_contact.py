#!/usr/bin/env python3
"""Contact of a disc in a hole that fits it closely, without friction: half angle, pressure.

    python3 conforming_contact.py RADIUS CLEARANCE E NU LOAD [THICKNESS] [--disc E NU]
    python3 conforming_contact.py 5e-3 1e-4 0.8e9 0.46 1e4 3e-3
    python3 conforming_contact.py --limits           the series beside the closed form and Hertz
    python3 conforming_contact.py --curves           of the joint, for doc/figures/finger_joint.gnuplot

RADIUS of the hole and CLEARANCE (difference of the radii) in m, E in Pa, LOAD in N per m of
width, plane strain. The hole is in a plane without end, or in a layer of THICKNESS
whose back is held. The disc is rigid without --disc.

Displacements are small against the radius. With p(th) the pressure, u_n = C_n p_n the radial
displacement of the surfaces by its part cos(n th), and d the way of the disc,

    CLEARANCE + C_0 p_0 + sum_{n>1} C_n p_n cos(n th) = d cos(th)   in the contact.

The C_n are those of the layer (Michell) and of the disc; n = 1 belongs to d. p is a sum of
functions that are zero at the edge of the contact like a square root. It fulfils the equation
at points.

Closed form, for C_n = (2 R/E*) n/(n^2 - 1) and C_0 = c (2 R/E*), b = tan(half angle/2):

    E* CLEARANCE/LOAD = (1 - c (ln(1 + b^2) + 2 b^4)) / (pi b^2 (1 + b^2))
    p(0) R/LOAD = artanh(b/sqrt(1 + b^2)) / (pi b^2 (1 + b^2)) + 2 b/(pi sqrt(1 + b^2))

Disc and plane of the same material have c = 1/2: Persson 1964. So has no other pair exactly;
a rigid disc in an incompressible plane has c = 1. For b -> 0 it is Hertz:
half angle = sqrt(4 LOAD/(pi E* CLEARANCE)), p(0) = 2 LOAD/(pi R half angle).
"""
import math
import sys


def solve(rows):
    """Gauss elimination of an augmented matrix."""
    n = len(rows)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, n):
            f = rows[i][k] / rows[k][k]
            if f:
                for j in range(k, n + 1):
                    rows[i][j] -= f * rows[k][j]
    x = [0.0] * n
    for k in reversed(range(n)):
        x[k] = (rows[k][n] - sum(rows[k][j] * x[j] for j in range(k + 1, n))) / rows[k][k]
    return x


def fields(n, r, scale, mu, kappa):
    """u_r, u_t, sigma_rr, sigma_rt at r of four solutions, each (r/scale)^power."""
    columns = []
    for power, sign, s in ((n + 1, 1, scale[1]), (1 - n, -1, scale[0])):
        f = (r / s) ** power
        columns.append(((kappa - power) * f / (2 * mu), sign * (kappa + power) * f / (2 * mu),
                        power * (3 - power) * f / r, sign * power * (power - 1) * f / r))
    for power, sign, s in ((n - 1, 1, scale[1]), (-n - 1, -1, scale[0])):
        f = (r / s) ** power
        columns.append((-f / (2 * mu), sign * f / (2 * mu), -power * f / r, sign * power * f / r))
    return columns


def layer(n, a, b, young, nu):
    """C_n of the inner side of a ring a < r < b, held at b; b None: no end."""
    mu, kappa = young / (2 + 2 * nu), 3 - 4 * nu
    if n == 0:
        if b is None:
            return a / (2 * mu)
        # u = A r + B/r, zero at b
        A = 1 / (-2 * mu / (1 - 2 * nu) - 2 * mu * b * b / (a * a))
        return A * a - A * b * b / a
    at_a = fields(n, a, (a, b or a), mu, kappa)
    if b is None:
        x, y = solve([[at_a[1][2], at_a[3][2], -1], [at_a[1][3], at_a[3][3], 0]])
        return x * at_a[1][0] + y * at_a[3][0]
    at_b = fields(n, b, (a, b), mu, kappa)
    x = solve([[c[2] for c in at_a] + [-1], [c[3] for c in at_a] + [0],
               [c[0] for c in at_b] + [0], [c[1] for c in at_b] + [0]])
    return sum(f * c[0] for f, c in zip(x, at_a))


def disc(n, a, young, nu):
    """C_n of a disc, positive inwards."""
    mu, kappa = young / (2 + 2 * nu), 3 - 4 * nu
    if n == 0:
        return (1 - 2 * nu) * a / (2 * mu)
    at_a = fields(n, a, (a, a), mu, kappa)
    x, y = solve([[at_a[0][2], at_a[2][2], -1], [at_a[0][3], at_a[2][3], 0]])
    return -(x * at_a[0][0] + y * at_a[2][0])


def compliance(a, b, young, nu, other=None):
    """C_0, K, e and E_n, n < N, with C_n = (K n + e + E_n)/(n^2 - 1). E_n falls exponentially."""
    def ends(n):
        return layer(n, a, None, young, nu) + (disc(n, a, *other) if other else 0.0)

    K = 2 * a * ((1 - nu**2) / young + ((1 - other[1] ** 2) / other[0] if other else 0))
    e = 3 * ends(2) - 2 * K
    if abs(24 * ends(5) - 5 * K - e) > 1e-9 * K:
        raise ArithmeticError("the compliance of the plane has another form")
    E = [0.0, 0.0]
    if b is not None:
        for n in range(2, 4 + int(25 / math.log(b / a))):
            E.append((n * n - 1) * (layer(n, a, b, young, nu) - layer(n, a, None, young, nu)))
    return layer(0, a, b, young, nu) + (disc(0, a, *other) if other else 0.0), K, e, E


def contact(C, a, angle, functions=14):
    """Load and p(0) for a clearance of 1 at a half angle of contact.

    p = sum q_k sqrt(b^2 - t^2) U_2k(t/b), t = tan(th/2). K sum n p_n cos(n th) is then
    K (1 + t^2)/2 sum q_k (2k + 1) U_2k(t/b), and u'' + u = -CLEARANCE is what is solved."""
    C0, K, e, E = C
    b = math.tan(angle / 2)
    points = 2 * (len(E) + 40)
    # Moments p_n of the functions, half of the points by symmetry
    moments = [[0.0] * functions for _ in E]
    for i in range(points):
        f = (i + 0.5) * math.pi / (2 * points)
        t = b * math.cos(f)
        w = 2 * b * math.sin(f) * 2 / (1 + t * t) / math.pi * math.pi / (2 * points)
        values = [b * math.sin((2 * k + 1) * f) * w for k in range(functions)]
        theta = 2 * math.atan(t)
        for n in range(len(E)):
            c = math.cos(n * theta) * (0.5 if n == 0 else 1)
            for k in range(functions):
                moments[n][k] += values[k] * c
    rows = []
    for i in range(functions):
        f = (i + 0.5) * math.pi / (2 * functions)
        t = b * math.cos(f)
        theta = 2 * math.atan(t)
        row = []
        for k in range(functions):
            s = math.sin((2 * k + 1) * f)
            m = [moments[n][k] for n in range(len(E))]
            value = K * (1 + t * t) / 2 * (2 * k + 1) * s / math.sin(f) + e * b * s
            value -= (C0 + e) * m[0] + (K + e) * m[1] * math.cos(theta)
            value += sum(E[n] * m[n] * math.cos(n * theta) for n in range(2, len(E)))
            row.append(value)
        rows.append(row + [1.0])
    q = solve(rows)
    load = math.pi * a * sum(x * y for x, y in zip(q, moments[1]))
    return load, b * sum(x * (-1) ** k for k, x in enumerate(q))


def find(C, a, clearance, load, low=0.01, high=2.8):
    """Half angle and p(0) under a load."""
    f = lambda angle: 1 / contact(C, a, angle)[0] - clearance / load
    for _ in range(36):
        middle = 0.5 * (low + high)
        if f(middle) > 0:
            low = middle
        else:
            high = middle
    return middle, contact(C, a, middle)[1] * clearance


def closed_form(ratio, c):
    """Half angle and p(0) R/LOAD for E* CLEARANCE/LOAD."""
    g = lambda x: (1 - c * (math.log1p(x) + 2 * x * x)) / (math.pi * x * (1 + x)) - ratio
    low, high = 1e-12, 1e3
    for _ in range(200):
        x = 0.5 * (low + high)
        low, high = (x, high) if g(x) > 0 else (low, x)
    b = math.sqrt(x)
    return 2 * math.atan(b), (math.atanh(math.sqrt(x / (1 + x))) / (math.pi * x * (1 + x))
                              + 2 * b / (math.pi * math.sqrt(1 + x)))


def hertz(ratio):
    angle = math.sqrt(4 / (math.pi * ratio))
    return angle, 2 / (math.pi * angle)


def limits():
    """The series against closed forms and Hertz."""
    a, young = 1.0, 1.0
    print("E* dR/P | Hertz: angle [deg], p R/P | closed form c=1/2 | series, same material, nu 0.3 |"
          " closed form c=1 | series, rigid disc, nu 0.4999 | series, rigid disc, nu 0.46")
    same = compliance(a, None, young, 0.3, (young, 0.3))
    incompressible = compliance(a, None, young, 0.4999)
    polyethylene = compliance(a, None, young, 0.46)
    for ratio in (300, 100, 30, 10, 3, 1, 0.3, 0.1):
        row = [hertz(ratio), closed_form(ratio, 0.5),
               find(same, a, ratio * 2 * (1 - 0.3**2), 1), closed_form(ratio, 1.0),
               find(incompressible, a, ratio * (1 - 0.4999**2), 1), find(polyethylene, a, ratio * (1 - 0.46**2), 1)]
        print("%6g" % ratio, *("%9.4f %9.5f" % (math.degrees(x), y) for x, y in row))


def curves():
    """The joint, 1 GPa and 0.46: thickness at 100 N on 10 mm, then load at 3 mm."""
    def line(thickness, load):
        angle, pressure = find(compliance(5.1e-3, 5.1e-3 + thickness, 1e9, 0.46), 5.1e-3, 1e-4, load / 0.01)
        h_angle, h_pressure = hertz(1e9 / (1 - 0.46**2) * 1e-4 / (load / 0.01))
        print("%g,%g,%g,%g,%g,%g" % (1e3 * thickness, load, math.degrees(angle), 1e-6 * pressure,
                                     math.degrees(h_angle), 1e-6 * h_pressure * load / 0.01 / 5.1e-3))

    print("thickness [mm],load [N],half angle [deg],pressure [MPa],Hertz half angle [deg],Hertz pressure [MPa]")
    for i in range(31):
        line(0.4e-3 * (15 / 0.4) ** (i / 30), 100)
    print("\n")
    for i in range(31):
        line(3e-3, 8 * (600 / 8) ** (i / 30))


def main():
    arguments = sys.argv[1:]
    if arguments == ["--limits"]:
        return limits()
    if arguments == ["--curves"]:
        return curves()
    other = None
    if "--disc" in arguments:
        i = arguments.index("--disc")
        other = tuple(map(float, arguments[i + 1 : i + 3]))
        del arguments[i : i + 3]
    if len(arguments) not in (5, 6):
        sys.exit(__doc__)
    a, clearance, young, nu, load = map(float, arguments[:5])
    b = a + float(arguments[5]) if len(arguments) == 6 else None
    angle, pressure = find(compliance(a, b, young, nu, other), a, clearance, load)
    print("half angle %.4f degrees, largest pressure %.6g Pa" % (math.degrees(angle), pressure))
    stiffness = 1 / ((1 - nu**2) / young + ((1 - other[1] ** 2) / other[0] if other else 0))
    h_angle, h_pressure = hertz(stiffness * clearance / load)
    print("Hertz: half angle %.4f degrees, largest pressure %.6g Pa" % (math.degrees(h_angle), h_pressure * load / a))


if __name__ == "__main__":
    main()
