#pragma once

/// How long until a centre at (x, y), which flies at (vx, vy), is `free` away from the origin. [s]
inline double time_to_rim(double x, double y, double vx, double vy, double free)
{
    (void)x, (void)y, (void)vx, (void)vy, (void)free;
    return 0.0; // your code here
}
