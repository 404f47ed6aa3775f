/* The rules of an event on whose surface a motion is: the same as in `run/departure.py`. Exported units
   include this file too. */

#ifndef DEPARTURE_H
#define DEPARTURE_H

INLINE int sign_of(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

/* Tell whether an expression is zero, as far as a bound on its roundings tells. */
INLINE int is_on_surface(double value, double bound)
{
    return value == 0.0 || absolute(value) <= ROUNDINGS * ROUNDING * bound;
}

/* Tell whether an event on whose surface a motion starts happens there, and whether it acts. */
INLINE int happens_at_start(int64_t side, int64_t direction)
{
    return side != 0 && (direction == 0 || direction == side);
}

INLINE int acts_at_start(int64_t side, int64_t direction, int stationary)
{
    return happens_at_start(side, direction) && (direction != 0 || stationary);
}

/* Tell whether an event that has acted at rest on its surface happens again at once: where the motion
   departs to the side that its direction points to; without one, at the start, where the origin is 0. */
INLINE int follows_itself(int64_t side, int64_t origin, int64_t direction)
{
    return side != 0 && (direction == side || (direction == 0 && origin == 0));
}

#endif
