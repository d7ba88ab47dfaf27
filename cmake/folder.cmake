# shadefit_folder(LIBRARY [HOT] FILE.. [ALONE FILE..]): the .cpp files of the folder that calls it, as a target of its own, whose objects
# become part of shadefit_LIBRARY. fit/study is folder_fit_study.
# The files of a folder instantiate the same templates: in one batch they compile in half the time. So no two of them may define the same
# name, not even one without linkage. HOT: the loops of fits, with -O2; all else runs once or waits for others' code, and has -O1.
# ALONE: a unit of its own, because it takes more optimising, or includes headers of others that define many macros.
# The variables shadefit_links and shadefit_numbers come from the library's folder.
function(shadefit_folder library)
  cmake_parse_arguments(PARSE_ARGV 1 folder "HOT" "" "ALONE")
  file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  foreach(file IN LISTS folder_UNPARSED_ARGUMENTS folder_ALONE)
    set_property(GLOBAL APPEND PROPERTY shadefit_sources_of_${library} ${name}/${file})
  endforeach()
  string(REPLACE "/" "_" name folder_${name})
  add_library(${name} OBJECT ${folder_UNPARSED_ARGUMENTS} ${folder_ALONE})
  target_sources(shadefit_${library} PRIVATE $<TARGET_OBJECTS:${name}>)
  if(folder_ALONE)
    set_source_files_properties(${folder_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  shadefit_compile(${name} "${folder_HOT}")
endfunction()

# How a target of ours compiles, whether a folder or the first file of a library.
function(shadefit_compile target hot)
  target_link_libraries(${target} PRIVATE ${shadefit_links} shadefit_options)
  if(shadefit_numbers)
    set_target_properties(${target} PROPERTIES SHADEFIT_NUMBERS ON)
  endif()
  if(hot)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O2>)
  elseif(SHADEFIT_SANITIZE AND shadefit_writes)
    # Under the sanitizers, optimising what reads and writes takes longer than its tests take without it.
    target_compile_options(${target} PRIVATE -O0)
  else()
    target_link_libraries(${target} PRIVATE shadefit_seldom)
  endif()
  # Without precompiled headers, most files would spend half of their time on the headers of others. No header of ours is in the list.
  # The first target with the same options precompiles them for all. GCC 12 crashes on headers that were precompiled with another
  # optimisation level. The preset `alone` uses neither precompiled headers nor batches, so that it finds an #include that is missing.
  set(options "hot ${hot}")
  if(SHADEFIT_SANITIZE)
    set(options "hot ${hot} numbers ${shadefit_numbers} writes ${shadefit_writes}")
  endif()
  get_property(first GLOBAL PROPERTY "shadefit_precompiled ${options}")
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <functional> <limits> <map> <optional> <span> <stdexcept>
      <string> <string_view> <utility> <vector> <ceres/jet.h>)
    set_property(GLOBAL PROPERTY "shadefit_precompiled ${options}" ${target})
  endif()
endfunction()

# shadefit_library(NAME PUBLIC TARGET.. [PRIVATE TARGET..]): a library of folders, which are added after it.
function(shadefit_library name)
  cmake_parse_arguments(PARSE_ARGV 1 library "" "" "PUBLIC;PRIVATE")
  add_library(shadefit_${name} STATIC)
  set_target_properties(shadefit_${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(shadefit_${name} PUBLIC ${library_PUBLIC} PRIVATE $<BUILD_INTERFACE:shadefit_options> ${library_PRIVATE})
  set(shadefit_links ${library_PUBLIC} ${library_PRIVATE} PARENT_SCOPE)
endfunction()

function(shadefit_folders)
  foreach(folder IN LISTS ARGN)
    add_subdirectory(${folder})
  endforeach()
endfunction()
