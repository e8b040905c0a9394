# Reads lcov's format; prints lines, lines that were run and their share for every folder, and files under `least` percent. Exit code 1 if all together is under it.
/^SF:/ { file = substr($0, 4); sub(root, "", file); folder = file; sub(/\/[^\/]*$/, "", folder) }
/^DA:/ { split(substr($0, 4), part, ","); ++lines[file]; ++all[folder]; ++total; if (part[2] + 0 > 0) { ++run[file]; ++reached[folder]; ++covered } }
END {
    if (total == 0) { print "coverage: no line was found"; exit 1 }
    for (name in all) printf "%-28s %6d lines %6d run %6.1f %%\n", name, all[name], reached[name], 100 * reached[name] / all[name] | "sort"
    close("sort")
    for (name in lines) if (100 * run[name] < least * lines[name]) printf "  below %d %%: %-40s %5d of %d\n", least, name, run[name], lines[name] | "sort"
    close("sort")
    printf "%-28s %6d lines %6d run %6.1f %%\n", "together", total, covered, 100 * covered / total
    exit 100 * covered < least * total
}
