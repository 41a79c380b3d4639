# clang for aarch64, with the C library and the linker of Debian's gcc for aarch64.
include(${CMAKE_CURRENT_LIST_DIR}/aarch64.cmake)
find_program(CROSS_CLANG NAMES clang-16 clang REQUIRED)
set(CMAKE_C_COMPILER ${CROSS_CLANG})
set(CMAKE_C_COMPILER_TARGET aarch64-linux-gnu)
