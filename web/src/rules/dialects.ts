// The dialects that a program may be in, as the server names them.
export const kDialects = ['fanuc', 'haas', 'mazak', 'mitsubishi-m80', 'sinumerik-840d'] as const;
