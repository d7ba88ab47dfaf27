# Finds only the headers of Ceres Solver, as the imported target CeresHeaders::CeresHeaders and CeresHeaders_VERSION.
#
# shadefit uses ceres/jet.h and ceres/tiny_solver.h, which need only Eigen. Ceres' own package requires glog, gflags,
# SuiteSparse, BLAS and LAPACK and fails if one is missing, although nothing here links them.
find_path(CeresHeaders_INCLUDE_DIR ceres/tiny_solver.h DOC "The directory that holds ceres/tiny_solver.h")
mark_as_advanced(CeresHeaders_INCLUDE_DIR)

if(CeresHeaders_INCLUDE_DIR AND EXISTS "${CeresHeaders_INCLUDE_DIR}/ceres/version.h")
  file(STRINGS "${CeresHeaders_INCLUDE_DIR}/ceres/version.h" CeresHeaders_LINES REGEX "define CERES_VERSION_(MAJOR|MINOR|REVISION) +[0-9]+")
  string(REGEX REPLACE "[^;0-9]" "" CeresHeaders_LINES "${CeresHeaders_LINES}")
  list(JOIN CeresHeaders_LINES "." CeresHeaders_VERSION)
  unset(CeresHeaders_LINES)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CeresHeaders REQUIRED_VARS CeresHeaders_INCLUDE_DIR VERSION_VAR CeresHeaders_VERSION)

if(CeresHeaders_FOUND AND NOT TARGET CeresHeaders::CeresHeaders)
  add_library(CeresHeaders::CeresHeaders INTERFACE IMPORTED)
  set_target_properties(CeresHeaders::CeresHeaders PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${CeresHeaders_INCLUDE_DIR}")
endif()
