"""Labels beside points, without a legend: each takes the first free place about its point."""

PLACES = [
    (7, 0, "left", "center"),
    (-7, 0, "right", "center"),
    (0, 7, "center", "bottom"),
    (0, -7, "center", "top"),
    (6, 6, "left", "bottom"),
    (6, -6, "left", "top"),
    (-6, 6, "right", "bottom"),
    (-6, -6, "right", "top"),
    (14, 16, "left", "bottom"),
    (14, -16, "left", "top"),
    (-14, 16, "right", "bottom"),
    (-14, -16, "right", "top"),
    (0, 24, "center", "bottom"),
    (0, -24, "center", "top"),
    (20, 32, "left", "bottom"),
    (20, -32, "left", "top"),
    (-20, 32, "right", "bottom"),
    (-20, -32, "right", "top"),
    (24, 48, "left", "bottom"),
    (24, -48, "left", "top"),
]
MIRRORED = {"left": "right", "right": "left", "center": "center"}


def _overlap(a, b):
    width = min(a[2], b[2]) - max(a[0], b[0])
    height = min(a[3], b[3]) - max(a[1], b[1])
    return max(0, width) * max(0, height)


def _box_of(annotation, renderer):
    box = annotation.get_window_extent(renderer)
    return (box.x0 - 2, box.y0 - 1, box.x1 + 2, box.y1 + 1)


def place(axes, points, others=()):
    """points: (x, y, text, color), in the axes' data. Greedy, in the order given; `others` are
    marks (x, y) to keep clear of as well."""
    figure = axes.figure
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    frame = axes.get_window_extent(renderer)
    marks = [axes.transData.transform(p[:2]) for p in [*points, *others]]
    taken = [(mx - 5, my - 5, mx + 5, my + 5) for mx, my in marks]
    for (x, y, text, color), (mx, _) in zip(points, marks):
        best = None
        mirror = -1 if mx > frame.x0 + 0.55 * frame.width else 1  # towards the middle first
        for dx, dy, across, along in PLACES:
            dx *= mirror
            across = across if mirror > 0 else MIRRORED[across]
            far = abs(dx) + abs(dy) > 12
            annotation = axes.annotate(
                text, (x, y), xytext=(dx, dy), textcoords="offset points", ha=across, va=along,
                color=color, fontsize=8, annotation_clip=False,
                arrowprops={"arrowstyle": "-", "color": color, "lw": 0.5, "shrinkA": 0,
                            "shrinkB": 3} if far else None)
            box = _box_of(annotation, renderer)
            outside = (box[2] - box[0]) * (box[3] - box[1]) - _overlap(
                box, (frame.x0, frame.y0, frame.x1 + 90, frame.y1 + 10))
            cost = sum(_overlap(box, other) for other in taken) + outside
            if best is None or cost < best[0] - 1e-9:
                if best:
                    best[1].remove()
                best = (cost, annotation, box)
            else:
                annotation.remove()
            if best[0] == 0:
                break
        taken.append(best[2])


def column(axes, points):
    """Labels of points (x, y, text, color) one below the other at the right, with lines to them."""
    figure = axes.figure
    figure.canvas.draw()
    to_axes = axes.transData + axes.transAxes.inverted()
    heights = [to_axes.transform(p[:2])[1] for p in points]
    gap = 14 / (axes.get_window_extent().height * 72 / figure.dpi)
    for y, (px, py, text, color) in zip(spread(heights, gap), points):
        axes.annotate(text, (px, py), xytext=(1.02, y), textcoords="axes fraction", va="center",
                      color=color, fontsize=8, annotation_clip=False,
                      arrowprops={"arrowstyle": "-", "color": color, "lw": 0.5, "shrinkA": 2,
                                  "shrinkB": 4, "relpos": (0, 0.5)})


def spread(values, gap):
    """Positions near the values, ascending as they are, at least `gap` apart, from 0 to 1 if they
    fit there."""
    order = sorted(range(len(values)), key=lambda i: values[i])
    places = [values[i] for i in order]
    for _ in range(200):
        moved = False
        for k in range(len(places) - 1):
            lack = gap - (places[k + 1] - places[k])
            if lack > 1e-6:
                places[k] -= lack / 2
                places[k + 1] += lack / 2
                moved = True
        if not moved:
            break
    places = [p - max(0, places[-1] - 1) for p in places]
    places = [max(p, k * gap) for k, p in enumerate(places)]
    result = [0.0] * len(values)
    for place_index, i in enumerate(order):
        result[i] = places[place_index]
    return result
