python
a = 1.57e+00  # shadefit: acos-linear.a
b = -.156538_0  # shadefit: acos-linear.form.b
c = 0x1F + 0.0  # shadefit: acos-liner.a
# shadefit: fresnel-quadratic.b
