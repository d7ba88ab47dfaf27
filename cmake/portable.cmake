# What a command for other systems links (docs/packaging.md). Included where the libraries are found, before PNG and JPEG.
#
# PNG, JPEG and zlib from their archives.
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
# Debian has no archives of fmt and toml++: their code is compiled into ours, and the linker leaves their shared objects out.
add_compile_definitions(FMT_HEADER_ONLY=1)
set_target_properties(fmt::fmt PROPERTIES INTERFACE_COMPILE_DEFINITIONS "")
set_target_properties(tomlplusplus::tomlplusplus PROPERTIES INTERFACE_COMPILE_OPTIONS "")
target_link_options(shadefit_options INTERFACE -Wl,--as-needed -static-libstdc++ -static-libgcc)
# No path of this machine.
target_compile_options(shadefit_options INTERFACE -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
