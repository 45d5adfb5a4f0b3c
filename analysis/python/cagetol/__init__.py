"""Results of cagetol for people who go on with pandas.

    import cagetol
    study = cagetol.read_study("out/nu205")
    study.samples.join(study.quantities).plot.scatter("cage.pocket_width_mm", "friction_torque_Nmm")
    study.units["friction_torque_Nmm"], study.definitions["friction_torque_Nmm"]
    run = cagetol.read_run("out/run.h5")
    cagetol.figures("out/nu205")["yield_curves"]
"""

from .figures import Drawing, figures
from .run import Run, read_run
from .study import Study, read_study

__all__ = ["Drawing", "Run", "Study", "figures", "read_run", "read_study"]
