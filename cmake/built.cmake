# Engine, scenes and levels as another build directory of this source, THUD_BUILT, has them already:
# of the same compiler and the same flags.

function(thud_built target folder)
    add_library(${target} STATIC IMPORTED GLOBAL)
    set_target_properties(${target} PROPERTIES IMPORTED_LOCATION
        ${THUD_BUILT}/${folder}/${CMAKE_STATIC_LIBRARY_PREFIX}${target}${CMAKE_STATIC_LIBRARY_SUFFIX})
    target_include_directories(${target} INTERFACE ${PROJECT_SOURCE_DIR}/${folder})
    target_link_libraries(${target} INTERFACE ${ARGN})
endfunction()

find_package(Threads REQUIRED)
thud_built(thud engine m)
target_include_directories(thud INTERFACE ${PROJECT_SOURCE_DIR}/engine/include)
thud_built(thud-scenes demo/scenes thud)
target_include_directories(thud-scenes INTERFACE ${PROJECT_SOURCE_DIR}/demo/scene
    ${THUD_BUILT}/demo/scenes)
thud_built(thud-level demo/level thud-scenes cjson expat z zstd)
add_library(thud-threads INTERFACE)
target_link_libraries(thud-threads INTERFACE thud ${CMAKE_THREAD_LIBS_INIT})
