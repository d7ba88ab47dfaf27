// The code of the loader, compiled once: its package's shared library would be one more to load at every
// start.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
