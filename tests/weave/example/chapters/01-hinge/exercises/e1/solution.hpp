#pragma once

/// Moment of inertia of the door of twice the width, over that of the door.
inline double ratio() { return 4.0; }
