"""What no measurement backs."""

import textwrap

UNBACKED = """
Nothing on this page compares the program with a measured bearing. It compares it with models, standards and formulas.

- **Slip.** No table of measured slip of a cylindrical roller bearing could be found in readable form. Abstracts agree
  that tested bearings became free of slip only above the makers' minimum load, that slip rises with speed and falls
  with load, tight clearance and warmer oil. More is not claimed. The load at 10 % slip moves with what nobody knows:
  oil layer, Eyring stress, pressure-viscosity coefficient, roughness, clearance.
- **Torque.** SKF's and Palmgren's models are fits to their makers' tests of steady, well lubricated, loaded bearings
  with standard cages. They know neither skidding nor the cage; below the minimum load, and at the aero bearing's speed,
  far beyond a catalogue bearing of that size, they are extrapolated.
- **Pocket forces, optimum of clearance.** No measurement. The place of the optimum follows the thickness of the oil
  layer, which is an assumption (20 um).
- **Cages.** Every cage dimension, guide clearance and pocket clearance is an assumption. So are Z and L_we, though
  held to two ratings, and the shoulders of the aero bearing.
- **Oil in the bearing.** Share of oil in the free space, oil layers, roughness, drag coefficients and limiting shear
  ratio are assumptions; contacts are isothermal but for the inlet's heating, and the temperature is an input.
- **ISO/TS 16281** shares the program's law of contact: the comparison tests the solution, not the law.
"""


def unbacked_section(page, _program, _quick):
    page.heading("What no measurement backs")
    page.add(*textwrap.dedent(UNBACKED).strip().splitlines(), "")
