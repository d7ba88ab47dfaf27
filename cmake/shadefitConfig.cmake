# The package shadefit: find_package(shadefit 0.1 [REQUIRED] [COMPONENTS approx fit])
#
#   approx  shadefit::approx, formulas and records: headers that need the standard library alone
#   fit     shadefit::fit, how constants are found: needs Eigen 3.4, the headers of Boost 1.74 and of Ceres 2.1
#
# Both have one include directory: #include "approx/fresnel.hpp", #include "fit/catalogue/family.hpp". Without COMPONENTS, approx is
# available, and fit if it and all its dependencies are found; check shadefit_fit_FOUND or TARGET shadefit::fit.
#
# The targets set no flags of yours. Fits are the same to the last bit on every compiler only with -ffp-contract=off,
# and the compiled part of fit is built so; templates that your own code instantiates are compiled with your flags.
set(shadefit_approx_FOUND TRUE)
set(shadefit_fit_FOUND FALSE)

foreach(shadefit_component IN LISTS shadefit_FIND_COMPONENTS)
  if(NOT shadefit_component MATCHES "^(approx|fit)$" AND shadefit_FIND_REQUIRED_${shadefit_component})
    set(shadefit_FOUND FALSE)
    set(shadefit_NOT_FOUND_MESSAGE "unknown component '${shadefit_component}': the components of shadefit are approx, fit")
    return()
  endif()
endforeach()

if(NOT shadefit_FIND_COMPONENTS OR "fit" IN_LIST shadefit_FIND_COMPONENTS)
  set(shadefit_MISSING "")
  if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/shadefit-fit.cmake")
    list(PREPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
    find_package(Eigen3 3.4 QUIET NO_MODULE)
    find_package(Boost 1.74 QUIET)
    find_package(CeresHeaders 2.1 QUIET)
    list(POP_FRONT CMAKE_MODULE_PATH)
    foreach(shadefit_dependency IN ITEMS "Eigen3 3.4" "Boost 1.74" "CeresHeaders 2.1")
      string(REGEX REPLACE " .*" "" shadefit_name "${shadefit_dependency}")
      if(NOT ${shadefit_name}_FOUND)
        list(APPEND shadefit_MISSING "${shadefit_dependency}")
      endif()
    endforeach()
    list(JOIN shadefit_MISSING ", " shadefit_MISSING)
  else()
    set(shadefit_MISSING "its own files, which this installation leaves out")
  endif()
  if(shadefit_MISSING STREQUAL "")
    set(shadefit_fit_FOUND TRUE)
  elseif(shadefit_FIND_REQUIRED_fit)
    set(shadefit_FOUND FALSE)
    set(shadefit_NOT_FOUND_MESSAGE "component fit lacks ${shadefit_MISSING}")
    return()
  endif()
endif()

include("${CMAKE_CURRENT_LIST_DIR}/shadefit-approx.cmake")
if(shadefit_fit_FOUND)
  include("${CMAKE_CURRENT_LIST_DIR}/shadefit-fit.cmake")
endif()
