// Holds the headers that all tests share: see target_precompile_headers in CMakeLists.txt.
