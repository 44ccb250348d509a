// Says how much of the sun and of the sky reaches a place.

// Gives 0 in shadow and 1 in the sun.
float sun_visibility(vec3 position, vec3 normal) { return 1.0; }

// Gives how much of the sky the crowd around a place leaves, 0 to 1.
float openness(vec3 position) { return 1.0; }
