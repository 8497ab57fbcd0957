(* JSON as docs/format.md wants it: strict, no member twice, numbers kept as they are written. *)

exception Malformed of string

type t =
  | Object of (string * t) list
  | Array of t list
  | String of string
  | Number of string
  | Literal

let max_depth = 8
let is_digit c = c >= '0' && c <= '9'

(* A number as it is written: sign, digits before and after the point, number of the latter, exponent if any. *)
type written = { negative : bool; whole : string; fraction : string; exponent : string option }

(* -?[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]+)?, or nothing. *)
let as_written text =
  let size = String.length text in
  let at = ref 0 in
  let take c = !at < size && text.[!at] = c && (incr at; true) in
  let digits () =
    let first = !at in
    while !at < size && is_digit text.[!at] do incr at done;
    String.sub text first (!at - first) in
  let negative = take '-' in
  let whole = digits () in
  let point = take '.' in
  let fraction = if point then digits () else "" in
  let power = take 'e' || take 'E' in
  let down = power && take '-' in
  if power && not down then ignore (take '+');
  let exponent = if power then Some (digits ()) else None in
  if whole = "" || (point && fraction = "") || exponent = Some "" || !at <> size then None
  else Some { negative; whole; fraction; exponent = Option.map (fun e -> if down then "-" ^ e else e) exponent }

let parse text =
  let size = String.length text in
  let at = ref 0 in
  let fail what = raise (Malformed (Printf.sprintf "byte %d: %s" !at what)) in
  let peek () = if !at < size then text.[!at] else '\000' in
  let is_space c = c = ' ' || c = '\t' || c = '\n' || c = '\r' in
  let skip () = while !at < size && is_space text.[!at] do incr at done in
  let next_is c = skip (); !at < size && text.[!at] = c in
  let expect c = if next_is c then incr at else fail (Printf.sprintf "expected '%c'" c) in
  let hexadecimal () =
    let code = ref 0 in
    for _ = 1 to 4 do
      let digit = match peek () with
        | '0' .. '9' as c -> Char.code c - 48
        | 'a' .. 'f' as c -> Char.code c - 87
        | 'A' .. 'F' as c -> Char.code c - 55
        | _ -> fail "expected four hexadecimal digits" in
      code := (16 * !code) + digit;
      incr at
    done;
    !code in
  let escape buffer =
    let c = peek () in
    incr at;
    match c with
    | '"' | '\\' | '/' -> Buffer.add_char buffer c
    | 'b' -> Buffer.add_char buffer '\b'
    | 'f' -> Buffer.add_char buffer '\012'
    | 'n' -> Buffer.add_char buffer '\n'
    | 'r' -> Buffer.add_char buffer '\r'
    | 't' -> Buffer.add_char buffer '\t'
    | 'u' ->
      let code = hexadecimal () in
      let code =
        if code < 0xD800 || code > 0xDFFF then code
        else if code > 0xDBFF || !at + 2 > size || String.sub text !at 2 <> "\\u" then fail "a lone surrogate"
        else begin
          at := !at + 2;
          let low = hexadecimal () in
          if low < 0xDC00 || low > 0xDFFF then fail "a lone surrogate";
          0x10000 + ((code - 0xD800) lsl 10) + (low - 0xDC00)
        end in
      Buffer.add_utf_8_uchar buffer (Uchar.of_int code)
    | _ -> fail "an escape that JSON does not have" in
  (* One character of more than a byte, which must be shortest, no surrogate, and at most U+10FFFF. *)
  let multibyte buffer =
    let byte i = if !at + i < size then Char.code text.[!at + i] else 0 in
    let first = byte 0 in
    let more = if first >= 0xF0 then 3 else if first >= 0xE0 then 2 else 1 in
    let code = ref (first land (0x3F lsr more)) in
    let good = ref (first >= 0xC2 && first <= 0xF4) in
    for i = 1 to more do
      good := !good && byte i land 0xC0 = 0x80;
      code := (!code lsl 6) lor (byte i land 0x3F)
    done;
    let least = [| 0; 0x80; 0x800; 0x10000 |].(more) in
    if not (!good && !code >= least && !code <= 0x10FFFF && (!code < 0xD800 || !code > 0xDFFF)) then
      fail "bytes that are not UTF-8";
    Buffer.add_string buffer (String.sub text !at (more + 1));
    at := !at + more + 1 in
  let string () =
    expect '"';
    let buffer = Buffer.create 16 in
    while if !at >= size then fail "a string without end" else text.[!at] <> '"' do
      let c = text.[!at] in
      if c < ' ' then fail "a control character in a string";
      if c >= '\128' then multibyte buffer
      else begin
        incr at;
        if c = '\\' then escape buffer else Buffer.add_char buffer c
      end
    done;
    incr at;
    Buffer.contents buffer in
  let scalar () =
    let first = !at in
    let ends c = is_space c || c = ',' || c = ']' || c = '}' || c = ':' in
    while !at < size && not (ends text.[!at]) do incr at done;
    let token = String.sub text first (!at - first) in
    if List.mem token [ "true"; "false"; "null" ] then Literal
    else
      match as_written token with
      | Some { whole; _ } when String.length whole = 1 || whole.[0] <> '0' -> Number token
      | _ -> at := first; fail "not a value" in
  (* What stands between commas, up to the closing bracket. *)
  let rec list close element found =
    let found = element () :: found in
    if next_is ',' then (incr at; list close element found) else (expect close; List.rev found) in
  let rec value depth =
    skip ();
    let c = peek () in
    if (c = '{' || c = '[') && depth = max_depth then fail "nested too deep";
    match c with
    | '{' ->
      incr at;
      let names = ref [] in
      let member () =
        skip ();
        let name = string () in
        if List.mem name !names then fail "a member occurs twice";
        if List.length !names = 16 then fail "an object with too many members";
        names := name :: !names;
        expect ':';
        (name, value (depth + 1)) in
      Object (if next_is '}' then (incr at; []) else list '}' member [])
    | '[' ->
      incr at;
      Array (if next_is ']' then (incr at; []) else list ']' (fun () -> value (depth + 1)) [])
    | '"' -> String (string ())
    | _ -> scalar () in
  let result = value 0 in
  skip ();
  if !at <> size then fail "text after the end of the document";
  result
