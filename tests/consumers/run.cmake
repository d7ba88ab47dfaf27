cmake_minimum_required(VERSION 3.25)

# Installs parts of a build into a fresh prefix and uses them as a stranger would: configures, builds and runs the
# consumer's project there. Run as a script with
#   BUILD     the build folder whose PARTS are installed, none: nothing is
#   SOURCE    instead of BUILD: sources to configure for the component approx alone
#   COMPILED  the sources of the libraries, relative to the project
#   CONSUMER  the consumer's project; WORK a folder of this test's own; OPTIONS further arguments of its configuration
set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${WORK})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

if(SOURCE)
  set(BUILD ${WORK}/shadefit)
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -DSHADEFIT_COMPONENTS=approx ${OPTIONS})
  run(${CMAKE_COMMAND} --build ${BUILD})
endif()
foreach(part IN LISTS PARTS)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component ${part})
endforeach()
if(CONSUMER)
  run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -DCMAKE_PREFIX_PATH=${prefix} ${OPTIONS})
  run(${CMAKE_COMMAND} --build ${WORK}/build)
endif()
foreach(program IN ITEMS consumer own_form)
  if(EXISTS ${WORK}/build/${program})
    run(${WORK}/build/${program})
  endif()
endforeach()

# Each installed header whose definitions are in a file of its own has them in the library.
if(fit IN_LIST PARTS)
  set(sources ${CMAKE_CURRENT_LIST_DIR}/../..)
  file(GLOB_RECURSE headers RELATIVE ${prefix}/include/shadefit ${prefix}/include/shadefit/fit/*.hpp
    ${prefix}/include/shadefit/reports/*.hpp)
  if(headers STREQUAL "")
    message(FATAL_ERROR "the component fit installed no header")
  endif()
  foreach(header IN LISTS headers)
    string(REGEX REPLACE "hpp$" "cpp" source ${header})
    if(EXISTS ${sources}/${source} AND NOT source IN_LIST COMPILED)
      message(FATAL_ERROR "${header} is installed, and the library has no ${source}")
    endif()
  endforeach()
endif()

# The command comes alone: a part installs its own files and no other's.
if(PARTS STREQUAL "command")
  file(GLOB_RECURSE files RELATIVE ${prefix} ${prefix}/*)
  set(expected bin/shadefit share/bash-completion/completions/shadefit share/man/man1/shadefit.1
    share/zsh/site-functions/_shadefit)
  file(GLOB_RECURSE studies RELATIVE ${CMAKE_CURRENT_LIST_DIR}/../.. ${CMAKE_CURRENT_LIST_DIR}/../../studies/*.toml ${CMAKE_CURRENT_LIST_DIR}/../../studies/*.csv)
  list(TRANSFORM studies PREPEND share/shadefit/)
  list(APPEND expected ${studies})
  list(SORT expected)
  if(NOT files STREQUAL expected)
    message(FATAL_ERROR "the component command installed ${files}")
  endif()
  run(${prefix}/bin/shadefit --version)
  run(${prefix}/bin/shadefit fit acos-linear)
endif()
