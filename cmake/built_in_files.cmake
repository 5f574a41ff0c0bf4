# Writes files (FILES, names below SOURCE, separated by spaces) as arrays of
# bytes into the C source OUTPUT: the list murk_KIND_files (base/built_in.h) of
# the header HEADER.
separate_arguments(FILES)
list(SORT FILES)
set(arrays "")
set(rows "")
set(number 0)
foreach(name ${FILES})
    file(READ ${SOURCE}/${name} bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
    string(APPEND arrays "static const unsigned char file_${number}[] = {\n${bytes}0};\n")
    string(APPEND rows "    {\"${name}\", (const char *)file_${number}, sizeof file_${number} - 1},\n")
    math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUTPUT} "#include \"${HEADER}\"\n\n${arrays}
static const murk_built_in_file files[] = {\n${rows}};
const murk_built_in murk_${KIND}_files = {files, ${number}};\n")
