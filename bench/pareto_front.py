"""Whether runs of a program lie below peristat's front, an error no larger in less time, and what errors cost."""

OURS = "peristat"
ROUNDING = 1e-14  # errors below are equal


def error_of(row):
    return max(row["error"], ROUNDING)


def cheapest(rows, row, clock):
    """Peristat's least time for an error no larger at no fewer points; `None` if it has no such run."""
    fits = [r for r in rows if r["program"] == OURS and error_of(r) <= error_of(row) and r["points"] >= row["points"]]
    return min(fits, key=lambda r: r[clock], default=None)


def front(rows, clock):
    """Peristat's runs that no other of its runs beats in both, from the fastest on."""
    best, kept = float("inf"), []
    for row in sorted((r for r in rows if r["program"] == OURS), key=lambda r: (r[clock], r["error"])):
        if error_of(row) < best:
            best = error_of(row)
            kept.append(row)
    return kept


def told(row):
    return f"{row['method']}, {row['size']}"


def milliseconds(seconds):
    return f"{1e3 * seconds:.3g}" if seconds < 1 else f"{1e3 * seconds:.0f}"


def verdicts(rows, clock, limit):
    """Per program: how many of its runs count, how many are below, and the one with the least time to peristat's.

    Where peristat has no run so accurate there is no ratio; the fastest such run is told.
    """
    head = ["program", "runs that count", "below", "its best run", "error", "ms", "peristat ms", "ratio", "beyond"]
    cells = []
    for program in dict.fromkeys(row["program"] for row in rows if row["program"] != OURS):
        mine = [r for r in rows if r["program"] == program and (limit is None or r["error"] < limit)]
        pairs = [(row, cheapest(rows, row, clock)) for row in mine]
        beyond = min((row for row, ours in pairs if ours is None), key=lambda r: r[clock], default=None)
        ratio = lambda pair: pair[0][clock] / pair[1][clock]
        reached = sorted((pair for pair in pairs if pair[1]), key=ratio)
        below = sum(ours is None for _, ours in pairs) + sum(ratio(pair) < 1 for pair in reached)
        line = [program, str(len(mine)), f"**{below}**" if below else "none"]
        if reached:
            row, ours = reached[0]
            times = milliseconds(row[clock]), milliseconds(ours[clock])
            line += [told(row), f"{row['error']:.1e}", *times, f"{ratio(reached[0]):.2g}"]
        else:
            line += [""] * 5
        last = f"{told(beyond)}: {beyond['error']:.1e} in {milliseconds(beyond[clock])} ms" if beyond else ""
        cells.append([*line, last])
    return head, cells


def costs(rows, errors, points):
    """Per method the least CPU milliseconds for an error at no fewer points, in brackets those inside the program."""
    head = ["program", "method", *(f"<= {error:g}" for error in errors)]
    cells = []
    for program, method in dict.fromkeys((row["program"], row["method"]) for row in rows):
        mine = [r for r in rows if (r["program"], r["method"]) == (program, method) and r["points"] >= points]
        line = [program, method]
        for error in errors:
            best = min((r for r in mine if r["error"] <= error), key=lambda r: r["cpu"], default=None)
            line.append(f"{milliseconds(best['cpu'])} ({milliseconds(best['inside'])})" if best else "-")
        cells.append(line)
    return head, cells
