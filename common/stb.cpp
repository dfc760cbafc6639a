// The bodies of the two libraries that read and write PNG and JPEG, and nothing of ours: their
// warnings and their compile time stay here.
#include <cstdlib>

// Memory starts as zeros: stb_image before version 2.28 decodes with Huffman tables that a hostile
// file never defined.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(pointer, size) std::realloc(pointer, size)
#define STBI_FREE(pointer) std::free(pointer)
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
