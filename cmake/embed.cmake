# cmake -DFILE=F -DNAME=N -DHEADER=H -DOUTPUT=C -P embed.cmake: writes the source C, which defines epsnet::N, declared in H, as the text of F.
# In this text @name@ alone in a line stands for the file of this name in the folder of F.
get_filename_component(folder ${FILE} DIRECTORY)
file(READ ${FILE} text)
string(REGEX MATCHALL "\n@[a-z.]+@" marks "${text}")
foreach(mark IN LISTS marks)
  string(REGEX REPLACE "[@\n]" "" name "${mark}")
  file(READ ${folder}/${name} part)
  string(REPLACE "${mark}" "\n${part}" text "${text}")
endforeach()
file(WRITE ${OUTPUT} "#include \"${HEADER}\"\n\nnamespace epsnet {\nconst std::string_view ${NAME} = R\"embedded(${text})embedded\";\n}\n")
