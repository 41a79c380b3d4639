# Fails if a C file is not formatted by .clang-format; clang-format-16 -i formats it.
get_filename_component(ROOT ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
set(FILES)
foreach(TREE engine demo tests web/wasm examples bindings/python)
    file(GLOB_RECURSE FOUND ${ROOT}/${TREE}/*.c ${ROOT}/${TREE}/*.h ${ROOT}/${TREE}/*.inl)
    list(APPEND FILES ${FOUND})
endforeach()
list(FILTER FILES EXCLUDE REGEX "/(target|node_modules|build)/")
execute_process(COMMAND ${CLANG_FORMAT} --dry-run --Werror --ferror-limit=20 ${FILES}
    RESULT_VARIABLE FAILED)
if(FAILED)
    message(FATAL_ERROR "run clang-format-16 -i on the files above")
endif()
