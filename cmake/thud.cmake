# The house's own CMake helpers: flags, sources that are compiled once per instruction set, tests.

# What it takes for float and double to be rounded to themselves: nothing on most platforms. Where
# nothing helps, or the caller asks for the x87, base.h says so.
include(CheckCSourceCompiles)
set(THUD_ROUNDING_FLAGS "")
set(rounds "#include <float.h>\nint main(void) { return 0; }
_Static_assert(FLT_EVAL_METHOD == 0, \"rounds otherwise\");")
check_c_source_compiles("${rounds}" THUD_ROUNDS)
if(NOT THUD_ROUNDS AND NOT CMAKE_C_FLAGS MATCHES "-mno-sse|-mfpmath=387")
    foreach(flags "-fexcess-precision=fast" "-msse2 -mfpmath=sse")
        string(MAKE_C_IDENTIFIER "THUD_ROUNDS${flags}" answer)
        set(CMAKE_REQUIRED_FLAGS ${flags})
        check_c_source_compiles("${rounds}" ${answer})
        if(${answer} AND NOT THUD_ROUNDING_FLAGS)
            separate_arguments(THUD_ROUNDING_FLAGS UNIX_COMMAND "${flags}")
        endif()
    endforeach()
    unset(CMAKE_REQUIRED_FLAGS)
endif()

# What every target of the project is held to. Nothing may be fused into one rounding, nor sums be
# put in another order where the whole project is compiled with -Ofast: the same source gives the
# same bits with every compiler and every SIMD width, scenes included. -fno-fast-math comes first,
# since it sets what other flags refine. A switch over
# an enum names every value of it, `default` or not, so that a new value is looked at everywhere.
function(thud_common_flags target)
    target_compile_options(${target} PRIVATE -fno-fast-math -Wall -Wextra -Wshadow -Wswitch-enum
        -ffp-contract=off
        ${THUD_ROUNDING_FLAGS})
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
    # Whatever links it, shared libraries too, is shown what has THUD_API, and calls the rest directly.
    set_target_properties(${target} PROPERTIES C_VISIBILITY_PRESET hidden)
    if(NOT EMSCRIPTEN)
        set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
        target_compile_options(${target} PRIVATE -fno-semantic-interposition)
    endif()
    if(BUILD_SHARED_LIBS)
        target_compile_definitions(${target} PRIVATE THUD_SHARED THUD_BUILDS)
    endif()
endfunction()

# Compiles the named sources into `target` once per instruction set. Each pass sees TD_ISA, the
# name that td_ functions of the pass end in: `base` is what the platform always has (SSE2, NEON,
# wasm SIMD128, or plain scalar), `avx2` is chosen at run time where the processor has it.
function(thud_wide_sources target)
    set(base_flags "")
    # As TD_HAS_AVX2 in base.h has it.
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$" AND NOT EMSCRIPTEN
            AND NOT (WIN32 AND CMAKE_C_COMPILER_ID STREQUAL "GNU"))
        _thud_wide_pass(${target} avx2 -mavx2 ${ARGN})
        separate_arguments(base_flags UNIX_COMMAND "${THUD_BASE_FLAGS}")
    endif()
    _thud_wide_pass(${target} base "${base_flags}" ${ARGN})
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
# root, so that it finds assets/, and it may include the engine's internal headers and tests/support.
# A test spends its time in the engine: -O1 compiles it in half the time of -O3.
function(thud_test file)
    get_filename_component(name ${file} NAME_WE)
    add_executable(${name} ${file})
    thud_common_flags(${name})
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    target_include_directories(${name} PRIVATE ${CMOCKA_INCLUDE_DIR}
        ${PROJECT_SOURCE_DIR}/engine/src ${PROJECT_SOURCE_DIR}/tests/support)
    target_compile_definitions(${name} PRIVATE TEST_SHARE=${THUD_TEST_SHARE})
    target_link_libraries(${name} PRIVATE ${ARGN} thud ${CMOCKA_LIBRARY})
    add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endfunction()

# thud_long_test(FILE [LIBRARY...]): a test that THUD_LONG_TESTS=OFF leaves out. tests/CMakeLists.txt
# says which tests these are.
function(thud_long_test file)
    if(THUD_LONG_TESTS)
        thud_test(${file} ${ARGN})
    endif()
endfunction()

# Sets a variable to the library's objects, whose symbols tests read by nm.
function(thud_objects variable)
    set(objects)
    foreach(target thud thud-base thud-avx2)
        if(TARGET ${target})
            list(APPEND objects $<TARGET_OBJECTS:${target}>)
        endif()
    endforeach()
    set(${variable} ${objects} PARENT_SCOPE)
endfunction()
