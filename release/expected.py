"""What the README's example gives, worked out here from what the definition says, not by Katydid."""

import math


def radii(columns=12, rows=9, spacing=10.0, at=(35.0, 55.0), smallest=0.8, largest=4.6):
    """The radii of the circles: at the points of a grid, running evenly from the nearest point to the farthest."""
    far = [math.dist((x * spacing, y * spacing), at) for x in range(columns + 1) for y in range(rows + 1)]
    low, high = min(far), max(far)
    return [largest + (one - low) / (high - low) * (smallest - largest) for one in far]


def compare(found, **sliders):
    """Nothing where the radii are those; else what differs."""
    wanted = radii(**sliders)
    if len(found) != len(wanted):
        return f"{len(found)} circles, and not {len(wanted)}"
    worst = max(abs(a - b) for a, b in zip(sorted(found), sorted(wanted)))
    return None if worst < 1e-9 else f"radii differ by {worst}"
