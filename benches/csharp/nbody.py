"""Five bodies in lists of numbers, 50,000 steps; the energy before and after."""

from math import sqrt


def energy(x, y, z, u, v, w, m):
    e = 0.0
    for i in range(len(m)):
        e += 0.5 * m[i] * (u[i] * u[i] + v[i] * v[i] + w[i] * w[i])
        for j in range(i + 1, len(m)):
            dx, dy, dz = x[i] - x[j], y[i] - y[j], z[i] - z[j]
            e -= m[i] * m[j] / sqrt(dx * dx + dy * dy + dz * dz)
    return e


def step(x, y, z, u, v, w, m, dt):
    n = len(m)
    for i in range(n):
        for j in range(i + 1, n):
            dx = x[i] - x[j]
            dy = y[i] - y[j]
            dz = z[i] - z[j]
            d2 = dx * dx + dy * dy + dz * dz
            mag = dt / (d2 * sqrt(d2))
            mi = m[i] * mag
            mj = m[j] * mag
            u[i] -= dx * mj
            v[i] -= dy * mj
            w[i] -= dz * mj
            u[j] += dx * mi
            v[j] += dy * mi
            w[j] += dz * mi
    for i in range(n):
        x[i] += dt * u[i]
        y[i] += dt * v[i]
        z[i] += dt * w[i]


def main():
    x = [0.0, 4.84, 8.34, 12.89, 15.38]
    y = [0.0, -1.16, 4.12, -15.11, -25.92]
    z = [0.0, -0.10, -0.40, -0.22, 0.18]
    u = [0.0, 0.606, -1.01, 1.08, 0.979]
    v = [0.0, 2.81, 1.82, 0.868, 0.594]
    w = [0.0, -0.02, 0.008, -0.01, -0.034]
    m = [39.47, 0.037, 0.011, 0.0017, 0.002]
    print(repr(energy(x, y, z, u, v, w, m)))
    for _ in range(50000):
        step(x, y, z, u, v, w, m, 0.001)
    print(repr(energy(x, y, z, u, v, w, m)))


main()
