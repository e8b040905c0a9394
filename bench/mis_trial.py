#!/usr/bin/env python3
"""Would multiple importance sampling between virtual ray lights and path tracing pay? Double scattering of a point light in a homogeneous, unbounded medium, seen along one ray.

    bench/mis_trial.py [--samples 400000] [--cost 20] [--rays 64] [--json mis_trial.json]      (needs NumPy)

Both techniques reach every path camera - x1 - x2 - light. Virtual ray lights: x2 lies on a ray from the light in a uniform direction, its place drawn by the angle that it is seen under
(isotropic marginal), x1 equi-angular. Path tracing: x1 and x2 by free flight and phase function, the light by next-event estimation. For every medium the script prints the variance over
squared mean that a unit of time leaves with each alone, and with the balance heuristic between them when half and a tenth of the time goes to path tracing; `--cost` is how many pairs of a
light and a pixel take the time of one such camera path.
"""
import argparse
import json

import numpy as np

MEDIA = {"thin, g 0": (.1, .0), "medium, g .55": (1., .55), "forward, g .9": (1., .9), "dense, g .3": (8., .3), "dense, g .9": (8., .9)}   # extinction per unit length (scene of size 1), g


def hg(g, mu):
    return (1 - g * g) / (4 * np.pi * (1 + g * g - 2 * g * mu) ** 1.5)


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


class Setting:
    """Camera at the origin looking along +x for a length of 2; the light somewhere beside the ray."""
    length = 2.

    def __init__(self, sigma_t, g, light):
        self.sigma_t, self.sigma_s, self.g, self.light = sigma_t, .9 * sigma_t, g, light

    def value(self, u, x2):
        """Radiance per (length, volume) of the path through u along the ray and x2."""
        leg = x2 - np.stack([u, 0 * u, 0 * u], -1)
        w2, away = np.sum(leg * leg, -1), x2 - self.light
        v2 = np.sum(away * away, -1)
        w, v = np.sqrt(w2), np.sqrt(v2)
        mu1, mu2 = -leg[:, 0] / w, -np.sum(away * leg, -1) / (v * w)
        value = self.sigma_s**2 * np.exp(-self.sigma_t * (u + w + v)) * hg(self.g, -mu1) * hg(self.g, mu2) / (w2 * v2)
        return np.where(u < self.length, value, 0.)

    # --- virtual ray lights
    def ray_angles(self, direction):
        """Closest approach of the light's ray and the camera's line: place on the ray, distance, sine of the angle between them."""
        sine2 = np.maximum(1 - direction[:, 0] ** 2, 1e-12)
        to = -self.light
        # minimise |light + v d - u x|
        foot = (to @ np.eye(3)[0] * -direction[:, 0] + direction @ to) / sine2
        closest = self.light + foot[:, None] * direction
        return foot, np.sqrt(closest[:, 1] ** 2 + closest[:, 2] ** 2) + 1e-9, np.sqrt(sine2)

    REACH = 6.

    def marginal(self, direction, v):
        foot, h, sine = self.ray_angles(direction)
        low, high = np.arcsinh(-foot * sine / h), np.arcsinh((self.REACH - foot) * sine / h)
        return sine / (np.sqrt(h * h + ((v - foot) * sine) ** 2) * (high - low))

    def draw_marginal(self, direction, xi):
        foot, h, sine = self.ray_angles(direction)
        low, high = np.arcsinh(-foot * sine / h), np.arcsinh((self.REACH - foot) * sine / h)
        return np.clip(foot + h / sine * np.sinh(low + xi * (high - low)), 1e-9, self.REACH)

    def equiangular(self, x2):
        d = np.sqrt(x2[:, 1] ** 2 + x2[:, 2] ** 2) + 1e-12
        return d, np.arctan((0 - x2[:, 0]) / d), np.arctan((self.length - x2[:, 0]) / d)

    def draw_rays(self, rng, n):
        z, phi = rng.uniform(-1, 1, n), rng.uniform(0, 2 * np.pi, n)
        r = np.sqrt(1 - z * z)
        direction = np.stack([z, r * np.cos(phi), r * np.sin(phi)], -1)
        x2 = self.light + self.draw_marginal(direction, rng.uniform(size=n))[:, None] * direction
        d, a, b = self.equiangular(x2)
        return np.clip(x2[:, 0] + d * np.tan(a + rng.uniform(size=n) * (b - a)), 0, self.length * (1 - 1e-12)), x2

    def density_rays(self, u, x2):
        away = x2 - self.light
        v = np.linalg.norm(away, axis=-1)
        d, a, b = self.equiangular(x2)
        inside = (v < self.REACH) & (u < self.length)
        return np.where(inside, self.marginal(away / v[:, None], v) / (4 * np.pi * v * v) * d / ((b - a) * (d * d + (u - x2[:, 0]) ** 2)), 0.)

    # --- path tracing
    def draw_paths(self, rng, n):
        u = -np.log1p(-rng.uniform(size=n)) / self.sigma_t
        g, xi = self.g, rng.uniform(size=n)
        mu = 1 - 2 * xi if abs(g) < 1e-3 else (1 + g * g - ((1 - g * g) / (1 - g + 2 * g * xi)) ** 2) / (2 * g)
        phi, s = rng.uniform(0, 2 * np.pi, n), np.sqrt(np.maximum(1 - mu * mu, 0))
        t = -np.log1p(-rng.uniform(size=n)) / self.sigma_t
        return u, np.stack([u, 0 * u, 0 * u], -1) + t[:, None] * np.stack([mu, s * np.cos(phi), s * np.sin(phi)], -1)

    def density_paths(self, u, x2):
        leg = x2 - np.stack([u, 0 * u, 0 * u], -1)
        w2 = np.sum(leg * leg, -1)
        w = np.sqrt(w2)
        return self.sigma_t**2 * np.exp(-self.sigma_t * (u + w)) * hg(self.g, leg[:, 0] / w) / w2


def second_moments(setting, rng, n, shares, cost):
    """Mean, and variance times time of both techniques alone and of the balance heuristic for the given shares of time that path tracing takes."""
    ur, xr = setting.draw_rays(rng, n)
    up, xp = setting.draw_paths(rng, n)
    fr, fp = setting.value(ur, xr), setting.value(up, xp)
    rr, rp, pr, pp = setting.density_rays(ur, xr), setting.density_paths(ur, xr), setting.density_rays(up, xp), setting.density_paths(up, xp)
    rays, paths = fr / rr, fp / np.maximum(pp, 1e-300)
    result = {"rays": (rays.mean(), rays.var()), "paths": (paths.mean(), paths.var() * cost)}
    for share in shares:
        a, b = 1 - share, share / cost          # samples of each in a unit of time
        wr, wp = fr / (a * rr + b * rp), fp / np.maximum(a * pr + b * pp, 1e-300)
        result[f"MIS, {share:.0%} of the time for paths"] = (a * wr.mean() + b * wp.mean(), a * wr.var() + b * wp.var())
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--samples", type=int, default=400000)
    parser.add_argument("--cost", type=float, default=20.)
    parser.add_argument("--rays", type=int, default=64)
    parser.add_argument("--json")
    arguments = parser.parse_args()
    rng, rows = np.random.default_rng(7), []
    for name, (sigma_t, g) in MEDIA.items():
        lights = [np.array([rng.uniform(0, 2), rng.uniform(.05, .7), 0]) for _ in range(arguments.rays)]
        table = [second_moments(Setting(sigma_t, g, light), rng, arguments.samples, (.1, .5), arguments.cost) for light in lights]
        row = {"medium": name}
        for key in table[0]:
            row[key] = float(np.median([t[key][1] / t[key][0] ** 2 for t in table]))
        row["means agree to"] = float(np.median([abs(t["paths"][0] / t["rays"][0] - 1) for t in table]))
        rows.append(row)
        print(", ".join(f"{k} {v:.3g}" if isinstance(v, float) else v for k, v in row.items()), flush=True)
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump({"cost": arguments.cost, "samples": arguments.samples, "rays": arguments.rays, "rows": rows}, file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main()
