#pragma once

/// Length of a string by its period.  [m]
inline double length_of(double period, double g) { return period * g; }
