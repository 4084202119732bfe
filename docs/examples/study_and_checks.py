"""A convergence study of a dictionary, and the checks of a folder."""

import json
import peristat

case = json.load(open("cases/plate/cantilever.json"))
study = peristat.study({
    "title": "cantilever", "case": case, "set": {"body.rectangle.spacing": 4},
    "refine": {"delta_convergence": {"factors": [1, 2, 4]}},
    "exact": [{"quantity": "tip", "value": 0.021674, "source": "biquadratic finite elements"}],
})
for quantity in study.quantities:
    print(quantity["name"], quantity.get("errors"), quantity["orders"])
study.table                  # one row per task; study.to_pandas() for a data frame

for outcome in peristat.verify("cases/beam"):
    print(outcome.case, outcome.verdict)
