//! What a Rhino.Compute server answers: definitions solved and geometry functions called, as JSON. No sockets: a server
//! hands over bodies and writes out what comes back.
