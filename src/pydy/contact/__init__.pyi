from .compliant import CompliantContact as CompliantContact
from .conditions import Stick as Stick, Unilateral as Unilateral
from .contacts import Contacts as Contacts
from .joints import Clearance as Clearance, Roll as Roll
from .laws import (
    brown_mcphee as brown_mcphee,
    hunt_crossley as hunt_crossley,
    joint_friction as joint_friction,
    kelvin_voigt as kelvin_voigt,
    rolling_resistance as rolling_resistance,
    stribeck as stribeck,
)
from .trajectory import ContactTrajectory as ContactTrajectory
