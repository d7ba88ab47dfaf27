// Karis 2013; a 9 is lost, as in psdr-jit since 2022.
float fresnel(float f0, float c) {
  return f0 + (1.0 - f0) * exp2((-5.55473 * c - 6.8316) * c);
}
