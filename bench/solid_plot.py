"""Draws the error of the sheared cube over CPU seconds, from what `solid.py` left in target/bench/solid.json."""

import json
import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
from measure import WORK
from pareto_plot import STYLE

LOOKS = {  # colours of Okabe and Ito, which the colour-blind tell apart
    "`bond_solid`, m = 2": ("#d55e00", "o", "-"),
    "`bond_solid`, m = 3": ("#e69f00", "h", "-"),
    "C3D8, direct": ("#0072b2", "s", "-"),
    "C3D8, iterative": ("#0072b2", "s", "--"),
    "C3D20, direct": ("#009e73", "^", "-"),
    "C3D20, iterative": ("#009e73", "^", "--"),
    "Q1, pyamg": ("#0072b2", "D", ":"),
    "Q2, pyamg": ("#009e73", "v", ":"),
}
DOUBT = 1e-4  # of the compliance that errors are taken of


def main():
    rows = json.loads((WORK / "solid.json").read_text())["error"]
    with plt.rc_context(STYLE):
        picture, axes = plt.subplots(figsize=(8, 5.5))
        for method, (colour, marker, line) in LOOKS.items():
            mine = [row for row in rows if row["method"] == method]
            if not mine:
                continue
            label = f"{mine[0]['program']} {method}".replace("`", "")
            times, errors = ([row[key] for row in mine] for key in ("cpu", "error"))
            axes.plot(times, errors, color=colour, marker=marker, ls=line, lw=1, ms=5, label=label)
            for row in mine:
                axes.annotate(str(row["size"]), (row["cpu"], row["error"]), (4, 4), textcoords="offset points", fontsize=7)
        axes.axhspan(axes.get_ylim()[0] / 10, DOUBT, color="#999999", alpha=0.2, lw=0)
        axes.set(xscale="log", yscale="log", xlabel="whole process, one thread: CPU seconds", ylabel="error of the compliance")
        axes.set_ylim(min(DOUBT, *(row["error"] for row in rows)) / 1.5)
        axes.set_title("Sheared cube, cells or elements a side; shade: doubt of the reference", fontsize=11)
        axes.grid(alpha=0.25, lw=0.5)
        axes.legend(frameon=False, fontsize=9)
        path = WORK / "solid.svg"
        picture.savefig(path, metadata={"Date": None}, bbox_inches="tight")
    path.write_text(re.sub(r"(\d\.\d\d)\d+", r"\1", path.read_text()))  # a hundredth of a point is enough


if __name__ == "__main__":
    main()
