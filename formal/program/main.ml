(* The program certify-proved: reads a net file, asks the checker that is extracted from Coq, prints one line. *)

let usage =
  "Usage: certify-proved [--print] FILE...\n\n\
   Checks net files on rational tiles by the checker whose theorem is proved in Coq\n\
   (docs/formal.md). - is standard input.\n\
   --print writes the document that was read, each number as an exact fraction,\n\
   and checks nothing.\n\
   Example: certify-proved net.json\n\n\
   The line of output is VERIFIED, REFUTED: rule, UNDECIDED: rule, or MALFORMED: why;\n\
   with several files it begins with the name of the file.\n\
   Exit codes: 0 verified, printed, or --help, 1 refuted, 2 undecided, 3 malformed\n\
   file, 64 usage, 70 internal fault; of several files the greatest.\n"

let magic = "\137EPSNET\n"

let read path =
  let channel = if path = "-" then stdin else open_in_bin path in
  set_binary_mode_in channel true;
  let text = Buffer.create 65536 in
  let chunk = Bytes.create 65536 in
  let rec more () =
    let size = input channel chunk 0 (Bytes.length chunk) in
    Buffer.add_subbytes text chunk 0 size;
    if size > 0 then more () in
  more ();
  if path <> "-" then close_in channel;
  Buffer.contents text

let name = function
  | Checker.Surface -> "surface"
  | Map -> "map"
  | Gluing -> "gluing"
  | Orientation -> "orientation"
  | Delaunay -> "delaunay"
  | Covering -> "covering"
  | Packing -> "packing"

let starts_with prefix text =
  String.length text >= String.length prefix && String.sub text 0 (String.length prefix) = prefix

(* The line and the exit code. *)
let answer print text =
  try
    if starts_with magic text then (2, "UNDECIDED: document: not for this checker: a compact file")
    else
      let root = Json.parse text in
      match Reader.not_for_this_checker root with
      | Some what -> (2, "UNDECIDED: document: not for this checker: " ^ what)
      | None ->
        let document = Reader.document root in
        if print then (Reader.print stdout document; (0, ""))
        else
          match Checker.decide document with
          | Checker.Verified -> (0, "VERIFIED")
          | Refuted rule -> (1, "REFUTED: " ^ name rule)
          | Undecided rule -> (2, "UNDECIDED: " ^ name rule)
          | Malformed -> (3, "MALFORMED: the structure is not whole")
  with
  | Json.Malformed why -> (3, "MALFORMED: " ^ why)
  | Stack_overflow -> (70, "FAULT: the stack ran out; more of it: ulimit -s unlimited")

let () =
  let arguments = List.tl (Array.to_list Sys.argv) in
  let print, files =
    match arguments with "--print" :: files -> (true, files) | files -> (false, files) in
  if files = [ "--help" ] then print_string usage
  else if files = [] || List.exists (starts_with "--") files || (print && List.length files > 1) then begin
    prerr_string usage;
    exit 64
  end
  else
    try
      let check code path =
        let this, line = answer print (read path) in
        if line <> "" then print_endline ((if List.length files > 1 then path ^ ": " else "") ^ line);
        flush stdout;
        max code this in
      exit (List.fold_left check 0 files)
    with Sys_error why ->
      prerr_endline ("certify-proved: " ^ why);
      exit 64
