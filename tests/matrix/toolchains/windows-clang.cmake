# clang for Windows on x86-64, with MinGW-w64's C library and its gcc's runtime library.
include(${CMAKE_CURRENT_LIST_DIR}/windows.cmake)
find_program(CROSS_CLANG NAMES clang-16 clang REQUIRED)
set(CMAKE_C_COMPILER ${CROSS_CLANG})
set(CMAKE_C_COMPILER_TARGET x86_64-w64-mingw32)
execute_process(COMMAND x86_64-w64-mingw32-gcc -print-libgcc-file-name
    OUTPUT_VARIABLE libgcc OUTPUT_STRIP_TRAILING_WHITESPACE)
get_filename_component(libgcc_folder "${libgcc}" DIRECTORY)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -L${libgcc_folder}")
