# The house's own CMake helpers: flags, sources that are compiled once per instruction set, tests.

# What every target of the project is held to. Nothing may be fused into one rounding: the same
# source gives the same bits with every compiler and every SIMD width, scenes included.
function(thud_common_flags target)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -ffp-contract=off)
    if(THUD_WERROR)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()

# The engine's own flags on top: errno is never read, so that sqrt is one instruction, and every
# function has its own section, so that a linker drops what a program never calls.
function(thud_engine_flags target)
    thud_common_flags(${target})
    target_compile_options(${target} PRIVATE -Wconversion -Wno-sign-conversion -fno-math-errno
        -ffunction-sections -fdata-sections)
endfunction()

# Compiles the named sources into `target` once per instruction set. Each pass sees TD_ISA, the
# name that td_ functions of the pass end in: `base` is what the platform always has (SSE2, NEON,
# wasm SIMD128, or plain scalar), `avx2` is chosen at run time where the processor has it.
function(thud_wide_sources target)
    _thud_wide_pass(${target} base "" ${ARGN})
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$" AND NOT EMSCRIPTEN)
        _thud_wide_pass(${target} avx2 -mavx2 ${ARGN})
        target_compile_definitions(${target} PRIVATE TD_HAS_AVX2=1)
    endif()
endfunction()

function(_thud_wide_pass target isa flags)
    set(objects ${target}-${isa})
    add_library(${objects} OBJECT ${ARGN})
    thud_engine_flags(${objects})
    # Vectors never cross a call between differently compiled files, which is what psabi is about.
    target_compile_options(${objects} PRIVATE ${flags} -Wno-psabi)
    target_compile_definitions(${objects} PRIVATE TD_ISA=${isa})
    target_include_directories(${objects} PRIVATE
        $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${objects}>)
endfunction()

# thud_test(FILE [LIBRARY...]) makes a ctest test of one cmocka program. It runs in the project's
# root, so that it finds assets/, and it may include the engine's internal headers.
function(thud_test file)
    find_path(CMOCKA_INCLUDE_DIR cmocka.h REQUIRED)
    find_library(CMOCKA_LIBRARY cmocka REQUIRED)
    mark_as_advanced(CMOCKA_INCLUDE_DIR CMOCKA_LIBRARY)
    get_filename_component(name ${file} NAME_WE)
    add_executable(${name} ${file})
    thud_common_flags(${name})
    target_include_directories(${name} PRIVATE ${CMOCKA_INCLUDE_DIR}
        ${PROJECT_SOURCE_DIR}/engine/src)
    target_link_libraries(${name} PRIVATE ${ARGN} thud ${CMOCKA_LIBRARY})
    add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endfunction()
