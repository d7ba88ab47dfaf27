// Eberly's arc cosine: 0.009 at most.
float fastAcos(float x) {
  float a = 1.5707f;    // shadefit: acos-linear.a
  float b = -0.156583f; // shadefit: acos-linear.b
  return sqrt(1.0 - x) * (a + b * x);
}
