# Plays portfile.cmake without vcpkg, whose tool cannot be had from the registries of packages: the functions
# that it calls do what vcpkg's do, but what is installed was built before, in BUILD.
#
# usage: cmake -DPORT=portfile.cmake -DPACKAGES=FOLDER -DBUILD=FOLDER -P vcpkg.cmake
cmake_minimum_required(VERSION 3.22)
get_filename_component(CURRENT_PORT_DIR "${PORT}" DIRECTORY)
set(CURRENT_PACKAGES_DIR "${PACKAGES}")
set(made "${PACKAGES}/share/thud")

function(need)
    foreach(path IN LISTS ARGN)
        if(NOT EXISTS "${path}")
            message(FATAL_ERROR "there is no ${path}")
        endif()
    endforeach()
endfunction()

function(vcpkg_cmake_configure)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
    execute_process(COMMAND "${CMAKE_COMMAND}" -S "${arg_SOURCE_PATH}" -B "${PACKAGES}-build" ${arg_OPTIONS}
        COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(vcpkg_cmake_install)
    execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PACKAGES}"
        COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(vcpkg_cmake_config_fixup)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "CONFIG_PATH" "")
    need("${PACKAGES}/${arg_CONFIG_PATH}/thud-config.cmake")
    file(MAKE_DIRECTORY "${PACKAGES}/share")
    file(RENAME "${PACKAGES}/${arg_CONFIG_PATH}" "${made}")
    file(REMOVE_RECURSE "${PACKAGES}/lib/cmake")
endfunction()

function(vcpkg_fixup_pkgconfig)
    need("${PACKAGES}/lib/pkgconfig/thud.pc" "${PACKAGES}/lib/pkgconfig/thud-threads.pc")
endfunction()

function(vcpkg_install_copyright)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
    need(${arg_FILE_LIST})
    configure_file("${arg_FILE_LIST}" "${made}/copyright" COPYONLY)
endfunction()

include("${PORT}")
