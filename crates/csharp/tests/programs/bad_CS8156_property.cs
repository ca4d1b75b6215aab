class P { int Q { get; set; } void M() { ref int r = ref Q; } static void Main() { } }
