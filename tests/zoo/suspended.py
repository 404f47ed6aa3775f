"""Hard points of suspensions: of planar ones, and of ones in space, of a left wheel."""

from pydy.vehicles.suspensions import DoubleWishbone, McPherson

# In the plane of y and z as complex numbers: the hinges of the arms, their ball joints, the wheel.
LOWER, UPPER = 0.35 + 0.22j, 0.42 + 0.50j
BALL, TOP, CENTER = 0.72 + 0.18j, 0.68 + 0.48j, 0.77 + 0.31j
SPRING, MOUNT = 0.58 + 0.20j, 0.50 + 0.66j
STRUT, TOWER = 0.66 + 0.40j, 0.60 + 0.88j


def point(place, x=0.0):
    return (x, place.real, place.imag)


# A tie rod parallel to the lower arm, of its length, keeps the motion in the plane.
PLANAR = {
    "lower_front": point(LOWER, 0.2), "lower_rear": point(LOWER, -0.25), "lower_outer": point(BALL),
    "tie_rod_inner": point(LOWER, -0.12), "tie_rod_outer": point(BALL, -0.12),
    "wheel_center": point(CENTER),
}  # fmt: skip
WISHBONE = DoubleWishbone(
    **PLANAR, upper_front=point(UPPER, 0.15), upper_rear=point(UPPER, -0.2), upper_outer=point(TOP),
    spring_inner=point(MOUNT), spring_outer=point(SPRING),
)  # fmt: skip
STRUTTED = McPherson(**PLANAR, strut_top=point(TOWER), strut_bottom=point(STRUT))
SPATIAL = {
    "wishbone": DoubleWishbone(
        lower_front=(0.2, 0.35, 0.22), lower_rear=(-0.2, 0.33, 0.2), lower_outer=(0, 0.72, 0.18),
        upper_front=(0.12, 0.42, 0.5), upper_rear=(-0.2, 0.44, 0.48),
        upper_outer=(-0.02, 0.68, 0.48), tie_rod_inner=(-0.12, 0.36, 0.25),
        tie_rod_outer=(-0.13, 0.7, 0.22), wheel_center=(0, 0.77, 0.31),
        spring_inner=(0, 0.5, 0.65), spring_outer=(0, 0.6, 0.2), camber=-0.01, toe=0.003,
    ),
    "strut": McPherson(
        lower_front=(0.15, 0.35, 0.2), lower_rear=(-0.15, 0.35, 0.22),
        lower_outer=(0.01, 0.7, 0.18), strut_top=(-0.02, 0.58, 0.85), strut_bottom=(0, 0.64, 0.4),
        tie_rod_inner=(-0.12, 0.38, 0.26), tie_rod_outer=(-0.12, 0.68, 0.25),
        wheel_center=(0, 0.75, 0.3), camber=-0.01, toe=0.003,
    ),
}  # fmt: skip
