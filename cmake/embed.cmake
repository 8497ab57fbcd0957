# cmake -DFILE=F -DNAME=N -DOUTPUT=C -P embed.cmake: writes the source C, which defines the string_view epsnet::N as the text of F.
# In this text @name@ alone in a line stands for the file of this name in the folder of F.
get_filename_component(folder ${FILE} DIRECTORY)
file(READ ${FILE} text)
string(REGEX MATCHALL "\n@[a-z.]+@" marks "${text}")
foreach(mark IN LISTS marks)
  string(REGEX REPLACE "[@\n]" "" name "${mark}")
  file(READ ${folder}/${name} part)
  string(REPLACE "${mark}" "\n${part}" text "${text}")
endforeach()
file(WRITE ${OUTPUT} "#include <string_view>\n\nnamespace epsnet {\nextern const std::string_view ${NAME};\nconst std::string_view ${NAME} = R\"embedded(${text})embedded\";\n}\n")
