# The package shadefit: find_package(shadefit 0.1 [REQUIRED] [COMPONENTS approx fit study])
#
#   approx  shadefit::approx, formulas and records: headers that need the standard library alone
#   fit     shadefit::fit, how constants are found: needs Eigen 3.4, the headers of Boost 1.74 and of Ceres 2.1
#   study   shadefit::study, a study from its text, fitted, proven and as code: needs MPFI too
#
# All have one include directory: #include "approx/fresnel.hpp", "fit/catalogue/family.hpp", "reports/studies/prepare.hpp".
# Without COMPONENTS, approx is available, and of the others those that are found with all their dependencies; check
# shadefit_fit_FOUND or TARGET shadefit::fit.
#
# The targets set no flags of yours. Fits are the same to the last bit on every compiler only with -ffp-contract=off,
# and the compiled part of fit is built so; templates that your own code instantiates are compiled with your flags.
set(shadefit_approx_FOUND TRUE)
set(shadefit_fit_FOUND FALSE)
set(shadefit_study_FOUND FALSE)

foreach(shadefit_component IN LISTS shadefit_FIND_COMPONENTS)
  if(NOT shadefit_component MATCHES "^(approx|fit|study)$" AND shadefit_FIND_REQUIRED_${shadefit_component})
    set(shadefit_FOUND FALSE)
    set(shadefit_NOT_FOUND_MESSAGE "unknown component '${shadefit_component}': the components of shadefit are approx, fit, study")
    return()
  endif()
endforeach()

set(shadefit_NEEDED_BY_fit "Eigen3 3.4" "Boost 1.74" "CeresHeaders 2.1")
set(shadefit_NEEDED_BY_study ${shadefit_NEEDED_BY_fit} Mpfi shadefit_fit)
foreach(shadefit_component IN ITEMS fit study)
  # study is on top of fit.
  if(shadefit_FIND_COMPONENTS AND NOT shadefit_FIND_COMPONENTS MATCHES "${shadefit_component}|study")
    continue()
  endif()
  set(shadefit_MISSING "its own files, which this installation leaves out")
  if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/shadefit-${shadefit_component}.cmake")
    set(shadefit_MISSING "")
    list(PREPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
    find_package(Eigen3 3.4 QUIET NO_MODULE)
    find_package(Boost 1.74 QUIET)
    find_package(CeresHeaders 2.1 QUIET)
    find_package(Mpfi QUIET)
    list(POP_FRONT CMAKE_MODULE_PATH)
    foreach(shadefit_dependency IN LISTS shadefit_NEEDED_BY_${shadefit_component})
      string(REGEX REPLACE " .*" "" shadefit_name "${shadefit_dependency}")
      if(NOT ${shadefit_name}_FOUND)
        list(APPEND shadefit_MISSING "${shadefit_dependency}")
      endif()
    endforeach()
    list(JOIN shadefit_MISSING ", " shadefit_MISSING)
  endif()
  if(shadefit_MISSING STREQUAL "")
    set(shadefit_${shadefit_component}_FOUND TRUE)
  elseif(shadefit_FIND_REQUIRED_${shadefit_component})
    set(shadefit_FOUND FALSE)
    set(shadefit_NOT_FOUND_MESSAGE "component ${shadefit_component} lacks ${shadefit_MISSING}")
    return()
  endif()
endforeach()

include("${CMAKE_CURRENT_LIST_DIR}/shadefit-approx.cmake")
foreach(shadefit_component IN ITEMS fit study)
  if(shadefit_${shadefit_component}_FOUND)
    include("${CMAKE_CURRENT_LIST_DIR}/shadefit-${shadefit_component}.cmake")
  endif()
endforeach()
