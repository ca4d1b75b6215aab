SOLIDS = {}
