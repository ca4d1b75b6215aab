"""parallel.run: a function over a list. It runs in order: the host holds the geometry, and answers one call at a time."""


def run(function, data_list, flatten_results=False):
    """The results in order; lists among them are joined where `flatten_results` is asked."""
    results = [function(item) for item in data_list]
    if not flatten_results:
        return results
    flat = []
    for result in results:
        if isinstance(result, (list, tuple)):
            flat.extend(result)
        else:
            flat.append(result)
    return flat
