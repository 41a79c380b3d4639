# What find_package(thud) reads: thud::thud, and thud, as where thud is a part of the project.
include(${CMAKE_CURRENT_LIST_DIR}/thud-targets.cmake)
if(NOT TARGET thud)
    add_library(thud ALIAS thud::thud)
endif()
