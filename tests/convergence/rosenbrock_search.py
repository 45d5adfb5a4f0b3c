#!/usr/bin/env python3
"""Linearly implicit methods of order 4(3), stiffly accurate: coefficients from the conditions they
meet. Six stages that carry an oscillation on with the right frequency (tests/STEP_CONTROL.md, What
light touches do), or five (tests/STEP_CONTROL.md, A stage less).

    rosenbrock_search.py 6 [GAMMA [REST]]     0.185 and -0.0001 unless told
    rosenbrock_search.py 5 [GAMMA]            0.2625 unless told

REST is what is left of the fifth condition on linear equations; with 0 the method is of order 5
there. Five stages have none: their stability function follows from gamma. Unknown are alpha_ij and
beta_ij = alpha_ij + gamma_ij; b is the last row of beta. The embedded solution is the argument of the
last stage: with six stages that is row 5 of beta, which keeps nothing of what is infinitely stiff;
with five alpha has a last row of its own. Conditions in the notation of Hairer & Wanner II, IV.7,
sums with their diagonal. Starts are RODASP's coefficients, moved at random; with five stages random
numbers. Prints the coefficients as src/integration/rosenbrock.hpp has them, and what the method does
to an oscillation of 1.4 rad a step. Needs NumPy and SciPy; takes some minutes."""
import sys

import numpy as np
from scipy.optimize import least_squares

STAGES = int(sys.argv[1]) if len(sys.argv) > 1 else 6
SIX = STAGES == 6
ONES = np.ones(STAGES)
ALPHA = [(i, j) for i in range(5) for j in range(i)]  # with six stages the last row follows
BETA = [(i, j) for i in range(STAGES) for j in range(i)]
EMBEDDED_AT_INFINITY = 0.3  # of what is infinitely stiff, at most
RODASP_A = [[], [3], [1.831036793486759, 0.4955183967433795],
            [2.304376582692669, -0.05249275245743001, -1.176798761832782],
            [-7.170454962423024, -4.741636671481785, -16.31002631330971, -1.062004044111401],
            [-7.170454962423024, -4.741636671481785, -16.31002631330971, -1.062004044111401, 1]]
RODASP_C = [[], [-12], [-8.791795173947035, -2.207865586973518],
            [10.81793056857153, 6.780270611428266, 19.53485944642410],
            [34.19095006749676, 15.49671153725963, 54.74760875964130, 14.16005392148534],
            [34.62605830930532, 15.30084976114473, 56.99955578662667, 18.40807009793095,
             -5.714285714285717]]


def lower(rows):
    matrix = np.zeros((6, 6))
    for i, row in enumerate(rows):
        matrix[i, :len(row)] = row
    return matrix


def rodasp():
    gamma = np.linalg.inv(np.eye(6) / 0.25 - lower(RODASP_C))
    alpha = lower(RODASP_A) @ gamma
    return np.array([alpha[at] for at in ALPHA] + [(alpha + gamma)[at] for at in BETA])


def unpack(x, gamma):
    alpha, beta = np.zeros((STAGES, STAGES)), np.eye(STAGES) * gamma
    for at, value in zip(ALPHA, x):
        alpha[at] = value
    for at, value in zip(BETA, x[len(ALPHA):]):
        beta[at] = value
    if SIX:
        alpha[5, :5] = beta[4, :5]
    return alpha, beta


def conditions(x, gamma, rest):
    """What must vanish, and what should be small."""
    alpha, B = unpack(x, gamma)
    N = B - gamma * np.eye(STAGES)
    b, embedded, a, beta = B[-1], alpha[-1], alpha.sum(1), B @ ONES
    must = [b.sum() - 1, b @ beta - 1 / 2, b @ a**2 - 1 / 3, b @ B @ beta - 1 / 6,
            b @ a**3 - 1 / 4, b @ (a * (alpha @ beta)) - 1 / 8, b @ B @ a**2 - 1 / 12,
            b @ B @ B @ beta - 1 / 24,
            embedded.sum() - 1, embedded @ beta - 1 / 2, embedded @ a**2 - 1 / 3,
            embedded @ B @ beta - 1 / 6]
    v = 2 * B @ B @ ONES - a**2  # order on Prothero and Robinson's equation
    w = 6 * B @ B @ B @ ONES - a**3
    N2, N3, N4 = N @ N, N @ N @ N, N @ N @ N @ N
    if SIX:  # and the stage before the last is at the end of the step
        must += [a[4] - 1, 100 * (b @ B @ B @ B @ beta - 1 / 120 - rest), 30 * (N3 @ v)[-1]]
    order_5 = [b @ a**4 - 1 / 5, b @ (a**2 * (alpha @ beta)) - 1 / 10,
               b @ (a * (alpha @ a**2)) - 1 / 15, b @ (a * (alpha @ B @ beta)) - 1 / 30,
               b @ (alpha @ beta)**2 - 1 / 20, b @ B @ a**3 - 1 / 20,
               b @ B @ (a * (alpha @ beta)) - 1 / 40, b @ B @ B @ a**2 - 1 / 60]
    small = ([60 * k for k in order_5] + [0.05 * k for k in x]
             + [3 * max(0, -k) + 3 * max(0, k - 1) for k in a[1:4]]
             + [10 * (N2 @ w)[-1], 10 * (N3 @ w)[-1], 10 * (N4 @ w)[-1], 30 * (N4 @ v)[-1]])
    if not SIX:
        left = 1 - embedded @ np.linalg.solve(B, ONES)
        small += [10 * (N3 @ v)[-1], 4 * max(0, abs(left) - EMBEDDED_AT_INFINITY)]
    return np.array(must), np.array(small)


def solve(x, gamma, rest):
    for weight in (3, 30, 1e3, 3e4):
        def weighed(x, weight=weight):
            must, small = conditions(x, gamma, rest)
            return np.concatenate([weight * must, small])
        x = least_squares(weighed, x, max_nfev=400).x
    for _ in range(60):  # Newton, least change
        slopes = np.array([(conditions(x + d, gamma, rest)[0] - conditions(x - d, gamma, rest)[0]) / 2e-7
                           for d in 1e-7 * np.eye(len(x))]).T
        step = -np.linalg.lstsq(slopes, conditions(x, gamma, rest)[0], rcond=1e-10)[0]
        length = np.linalg.norm(step)
        x = x + step * min(1, 0.3 / max(length, 1e-30))
        if length < 1e-15:
            break
    return x


def table(x, gamma):
    alpha, beta = unpack(x, gamma)
    inverse = np.linalg.inv(beta - alpha)
    print("gamma", gamma)
    for name, matrix in (("a", alpha @ inverse), ("c", np.eye(STAGES) / gamma - inverse)):
        for i in range(1, STAGES):
            print(name, i + 1, *("%.17g" % k for k in matrix[i, :i]))
    print("alpha", *("%.17g" % k for k in alpha.sum(1)))
    print("gamma_sum", *("%.17g" % k for k in (beta - alpha).sum(1)))


def growth(x, gamma, z):
    """Over a step of y' = z y with h = 1; the method is stiffly accurate."""
    return np.linalg.solve(np.eye(STAGES) - z * unpack(x, gamma)[1], ONES.astype(complex))[-1]


def main():
    gamma = float(sys.argv[2]) if len(sys.argv) > 2 else 0.185 if SIX else 0.2625
    rest = float(sys.argv[3]) if len(sys.argv) > 3 else -1e-4
    first, enough = (0.21, 0.1) if SIX else (0.26, 0.21)
    random = np.random.default_rng(1)
    while True:  # most starts end in valleys of their own
        if SIX:
            start = rodasp() + random.normal(size=25) * random.choice([0.05, 0.2, 0.5])
        else:
            start = random.normal(size=20) * random.choice([0.3, 0.7])
        x = solve(start, first, 0)
        must, small = conditions(x, first, 0)
        met = np.abs(must).max() < 1e-12
        print("start:", "rest %.4f" % (small @ small) if met else "no solution", file=sys.stderr)
        if met and small @ small < enough:
            break
    for at in np.linspace(first, gamma, 1 + round(abs(gamma - first) / 0.0025))[1:]:
        x = solve(x, at, rest)
    must, small = conditions(x, gamma, rest)
    print("conditions to %.0e, rest %.4f" % (np.abs(must).max(), small @ small), file=sys.stderr)
    carried = growth(x, gamma, 1.4j)
    largest = max(abs(growth(x, gamma, 1j * y)) for y in np.geomspace(0.01, 1e4, 4000))
    print("1.4 rad: size %+.1e, frequency %+.1e; largest |R| on the imaginary axis 1 %+.0e"
          % (abs(carried) - 1, np.angle(carried) / 1.4 - 1, largest - 1), file=sys.stderr)
    table(x, gamma)


if __name__ == "__main__":
    main()
