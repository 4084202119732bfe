"""A quarter of a plate with a hole, in elements that follow the hole and get finer towards it and its top.

Nothing but NumPy: CalculiX gets the same elements as scikit-fem.
"""

import numpy as np


def quarter(plate, size):
    """Places (2 size + 1, 2 size + 1, 2) of nodes: along the hole from its side to its top, and away from it.

    Those with even numbers are corners of elements, those with one odd number are in the middle of sides.
    """
    (length, height), radius = plate.size, plate.radius
    corner = np.arctan2(height, length)
    share = np.linspace(0, 1, 2 * size + 1)
    # As many elements end at the right side as at the upper one.
    angle = np.where(share <= 0.5, 2 * share * corner, corner + (2 * share - 1) * (np.pi / 2 - corner))
    right, upper = length * np.tan(np.minimum(angle, corner)), height / np.tan(np.maximum(angle, corner))
    outside = np.where((share <= 0.5)[:, None], np.stack([0 * right + length, right], 1), np.stack([upper, 0 * upper + height], 1))
    to_top = np.pi / 2 * graded(1 - share, plate.finer[0])
    inside = radius * np.stack([np.sin(to_top), np.cos(to_top)], 1)
    outside[-1, 0] = inside[0, 1] = 0
    away = graded(share, plate.finer[1])[None, :, None]
    return inside[:, None] * (1 - away) + outside[:, None] * away


def graded(share, finer):
    """From 0 to 1, with first steps that are about e^`finer` times as short as the last."""
    return np.expm1(finer * share) / np.expm1(finer) if finer else share


def corners(across, along):
    """Numbers of the corners of elements in an `across` x `along` lattice of corners, counterclockwise."""
    number = np.arange(across * along).reshape(across, along)
    return np.stack([part.ravel() for part in (number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1])])
