"""Definitions solved at many points: on this machine, on a Ray cluster, with Dask, or as an optimiser asks for them.

    import katydid
    study = katydid.study("tower.kd", "plan.json", "study")
    study.run()                                  # as `katydid sweep tower.kd --plan plan.json -o study`
    study.run(engine="ray", address="auto")      # the same table, from a cluster
    study.evaluate([{"height": 3.2, "floors": 12}])["Area"]
"""

from .problem import Problem, cma_objective, optuna_trials, pymoo_problem
from .study import Progress, Study, StudyInput, Summary, study
from .table import Table

__all__ = ["Problem", "Progress", "Study", "StudyInput", "Summary", "Table", "cma_objective", "optuna_trials",
           "pymoo_problem", "study"]
