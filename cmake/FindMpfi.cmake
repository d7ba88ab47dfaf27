# Finds MPFI with MPFR and GMP below it, as the imported target Mpfi::Mpfi. Debian's package of MPFI brings no CMake files.
find_path(Mpfi_INCLUDE_DIR mpfi.h DOC "The directory that holds mpfi.h")
find_library(Mpfi_LIBRARY mpfi)
find_library(Mpfi_MPFR_LIBRARY mpfr)
find_library(Mpfi_GMP_LIBRARY gmp)
mark_as_advanced(Mpfi_INCLUDE_DIR Mpfi_LIBRARY Mpfi_MPFR_LIBRARY Mpfi_GMP_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Mpfi REQUIRED_VARS Mpfi_LIBRARY Mpfi_MPFR_LIBRARY Mpfi_GMP_LIBRARY Mpfi_INCLUDE_DIR)

if(Mpfi_FOUND AND NOT TARGET Mpfi::Mpfi)
  add_library(Mpfi::Mpfi INTERFACE IMPORTED)
  target_include_directories(Mpfi::Mpfi SYSTEM INTERFACE ${Mpfi_INCLUDE_DIR})
  target_link_libraries(Mpfi::Mpfi INTERFACE ${Mpfi_LIBRARY} ${Mpfi_MPFR_LIBRARY} ${Mpfi_GMP_LIBRARY})
endif()
