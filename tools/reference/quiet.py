"""
Takes the noise out of light that has bounced, and leaves surfaces as they are.

Bitterli et al. 2016, "Nonlinearly Weighted First-order Regression for Denoising Monte Carlo
Renderings": around each pixel the light is fitted as a linear function of where the surface is and
which way it faces, both of which the tracer knows exactly.
"""

import numpy

REACH = 4  # pixels
FACING = 0.35  # difference of normals that still counts
APART = 0.1  # metres out of the pixel's own plane, and a share of the distance along it
RIDGE = 1e-3
# What is brighter than so many times the middle of its neighbours is a stray path.
STRAY = 4


def quiet(light, normal, position):
    """`light` (irradiance, or what a mirror sees), normal and position: rows, columns, 3."""
    rows, columns, _ = light.shape
    wrap = lambda image: numpy.pad(image, ((REACH, REACH), (REACH, REACH), (0, 0)), mode="edge")
    around = [(y, x) for y in range(2 * REACH + 1) for x in range(2 * REACH + 1)]
    padded = [wrap(image) for image in (light, normal, position)]
    at = lambda image, y, x: image[y : y + rows, x : x + columns]
    calm = calmed(light)
    padded[0] = wrap(calm)
    size = 7
    matrix = numpy.zeros((rows, columns, size, size))
    target = numpy.zeros((rows, columns, size, 3))
    spread = numpy.zeros((rows, columns)) + 1e-6
    count = numpy.zeros((rows, columns)) + 1e-9
    for y, x in around:
        away = numpy.linalg.norm(at(padded[2], y, x) - position, axis=-1)
        near = away < 0.5
        spread += numpy.where(near, away, 0)
        count += near
    spread = (spread / count)[..., None]
    for y, x in around:
        l, n, p = (at(image, y, x) for image in padded)
        turned, moved = n - normal, (p - position) / spread
        off = numpy.abs(((p - position) * normal).sum(-1))
        weight = numpy.exp(-((turned**2).sum(-1)) / FACING**2 - (off / APART) ** 2)
        weight *= (numpy.linalg.norm(p - position, axis=-1) < 0.5) * (numpy.linalg.norm(n, axis=-1) > 0.5)
        feature = numpy.concatenate([numpy.ones((rows, columns, 1)), turned, moved * 0.5], axis=-1)
        weighted = feature * weight[..., None]
        matrix += weighted[..., :, None] * feature[..., None, :]
        target += weighted[..., :, None] * l[..., None, :]
    ridge = numpy.eye(size) * RIDGE
    ridge[0, 0] = 1e-9
    total = matrix[..., :1, :1]
    fitted = numpy.linalg.solve(matrix + ridge * numpy.maximum(total, 1) * 10, target)[..., 0, :]
    sure = (total[..., 0] > 4) & (numpy.linalg.norm(normal, axis=-1) > 0.5)[..., None]
    low, high = 0.3 * calm.min(-1, keepdims=True), 3 * calm.max(-1, keepdims=True)
    return numpy.where(sure, numpy.clip(fitted, low, high), calm)


def calmed(light):
    """Without stray paths: no pixel outshines its neighbours by far."""
    rows, columns, _ = light.shape
    padded = numpy.pad(light, ((1, 1), (1, 1), (0, 0)), mode="edge")
    nine = [padded[y : y + rows, x : x + columns] for y in range(3) for x in range(3)]
    middle = numpy.median(numpy.stack(nine), axis=0)
    return numpy.minimum(light, STRAY * middle + 1e-6)
