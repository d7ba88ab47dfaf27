# shadefit_folder(LIBRARY [HOT] FILE.. [ALONE FILE..]): the .cpp files of the folder that calls it, as a part of shadefit_LIBRARY.
# The folders of a library are compiled in one batch, because they instantiate the same templates: it takes half of their time. So no two
# of their files may define the same name, not even one without linkage. Where a batch would take more than 1.5 GB, the folder above sets
# shadefit_batch, and its later folders are a batch of that name. HOT: the loops of fits, a batch with -O2; all else runs once or waits for
# others' code, and has -O1. ALONE: a unit of its own, because it takes more optimising, or includes headers of others that define many macros.
# The variables shadefit_links and shadefit_numbers come from the library's folder.
function(shadefit_folder library)
  cmake_parse_arguments(PARSE_ARGV 1 folder "HOT" "" "ALONE")
  set(batch ${library}${shadefit_batch}_seldom)
  if(folder_HOT)
    set(batch ${library}${shadefit_batch}_hot)
  endif()
  if(NOT TARGET ${batch})
    add_library(${batch} OBJECT)
    target_sources(shadefit_${library} PRIVATE $<TARGET_OBJECTS:${batch}>)
    shadefit_compile(${batch} "${folder_HOT}")
  endif()
  file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  list(TRANSFORM folder_UNPARSED_ARGUMENTS PREPEND ${name}/)
  list(TRANSFORM folder_ALONE PREPEND ${name}/)
  set_property(GLOBAL APPEND PROPERTY shadefit_sources_of_${library} ${folder_UNPARSED_ARGUMENTS} ${folder_ALONE})
  list(TRANSFORM folder_UNPARSED_ARGUMENTS PREPEND ${PROJECT_SOURCE_DIR}/)
  list(TRANSFORM folder_ALONE PREPEND ${PROJECT_SOURCE_DIR}/)
  target_sources(${batch} PRIVATE ${folder_UNPARSED_ARGUMENTS} ${folder_ALONE})
  if(folder_ALONE)
    set_source_files_properties(${folder_ALONE} TARGET_DIRECTORY ${batch} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
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

# shadefit_embed(FOLDER FILE..): the texts of FOLDER/FILE as NAME_files of FOLDER_files.hpp, in this order. NAME is that of the folder.
function(shadefit_embed folder)
  set(texts "")
  foreach(file IN LISTS ARGN)
    set(path ${PROJECT_SOURCE_DIR}/${folder}/${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
    file(READ ${path} text)
    get_filename_component(name ${file} NAME_WE)
    string(APPEND texts "    EmbeddedFile{\"${name}\", R\"text(${text})text\"},\n")
  endforeach()
  get_filename_component(name ${folder} NAME)
  configure_file(${PROJECT_SOURCE_DIR}/fit/support/embedded_files.hpp.in ${PROJECT_BINARY_DIR}/embedded/${folder}_files.hpp @ONLY)
endfunction()
