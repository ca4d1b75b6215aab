//! Params / Primitive: parameters that hold numbers, texts and the like.

use katydid_component::component;
use katydid_data::Tree;

parameters! {
    /// Truth values. Numbers other than 0 and the words true and yes are true.
    boolean, "cb95db89-6165-43b6-9c41-5702bc5bf137", "Boolean", "Bool", "Params/Primitive", Boolean;

    /// Whole numbers of 32 bits. Other numbers are rounded, halves to the even neighbour.
    integer, "2e3ab970-8545-46bb-836c-1c11e5610bce", "Integer", "Int", "Params/Primitive", Integer;

    /// Numbers. A text is read as a number or a formula without variables, such as `1/3`.
    number, "3e8ca6be-fda8-4aaf-b5c0-3c54c8bb7312", "Number", "Num", "Params/Primitive", Number;

    /// Texts. Any other data becomes the text that a panel shows for it.
    text, "3ede854e-c753-40eb-84cb-b48008f14fd4", "Text", "Txt", "Params/Primitive", Text;

    /// Colours. Texts such as `255,128,0` become colours.
    colour, "203a91c3-287a-43b6-a9c5-ebb96240a650", "Colour", "Col", "Params/Primitive", Colour;

    /// Complex numbers. A number becomes the complex number without an imaginary part.
    complex, "476c0cf8-bc3c-4f1c-a61a-6e91e1f8b91e", "Complex", "C", "Params/Primitive", Complex;

    /// Dates with a time of day.
    time, "81dfff08-0c83-4f1b-a358-14791d642d9e", "Time", "Time", "Params/Primitive", Time;

    /// Ranges of numbers. A number n becomes 0 to n, a text such as `2 to 5` the range it names.
    domain, "15b7afe5-d0d0-43e1-b894-34fcfe3be384", "Domain", "Domain", "Params/Primitive", Domain;

    /// Ranges in two directions, u and v.
    domain2, "90744326-eb53-4a0e-b7ef-4b45f5473d6e", "Domain²", "Domain²", "Params/Primitive", Domain2;

    /// Ranges in two directions, u and v, as early files have them.
    domain2_old, "fa36c19d-b108-440c-b33d-a0a4642b45cc", "Domain²", "Domain²", "Params/Primitive", Domain2;

    /// Identifiers of 128 bits.
    guid, "faf6e3bb-4c84-4cbf-bd88-6d6a0db5667a", "Guid", "ID", "Params/Primitive", Guid;

    /// Matrices.
    matrix, "bd4a8a18-a3cc-40ba-965b-3be91fee563b", "Matrix", "Matrix", "Params/Primitive", Matrix;

    /// Paths of data trees, such as `{0;1}`. A whole number becomes a path of one element.
    data_path, "56c9c942-791f-4eeb-a4f0-82b93f1c0909", "Data Path", "Path", "Params/Primitive", Path;

    /// Paths of files, as texts.
    file_path, "06953bda-1d37-4d58-9b38-4b3c74e54c8f", "File Path", "Path", "Params/Primitive", Text;

    /// Data of any type, unchanged.
    data, "8ec86459-bf01-4409-baee-174d0d2b13d0", "Data", "Data", "Params/Primitive", Generic;

    /// Ways to draw points.
    symbol_display, "2bcd153c-c964-4199-b8e4-4a19dfd34967", "Symbol Display", "SymDis", "Params/Primitive", Symbol;

    /// Numbers that do not change. An early form of the number parameter.
    constant, "4ad6703b-84cd-4957-a1b3-f1c6ec270d9c", "Constant", "constant", "Params/Primitive", Generic;

    /// Languages for texts and numbers, by their Windows code; 127 stands for none.
    culture, "7fa15783-70da-485c-98c0-a099e6988c3e", "Culture", "Culture", "Params/Primitive", Integer;

    /// Materials for previews. A colour becomes a plain material.
    shader, "288cfe66-f3dc-4c9a-bb96-ef81f47fe724", "Shader", "Shader", "Params/Primitive", Material;

    /// Data of any type from a source elsewhere, unchanged.
    receiver, "f19b8c33-dff2-4cc2-b95b-b4005ff3c10c", "Receiver", "Receiver", "Params/Primitive", Generic;
}
