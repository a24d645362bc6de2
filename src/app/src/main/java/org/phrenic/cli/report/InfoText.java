package org.phrenic.cli.report;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** What {@code info} found, as text: a heading, then a line for each value. */
public final class InfoText {
    private InfoText() {}

    public static String of(Map<String, Object> info) {
        TextTable table = new TextTable(false, false, false);
        info.forEach((key, value) -> {
            if (!key.equals("file") && !key.equals("kind")) {
                append(table, "  " + key, value);
            }
        });
        return info.get("file") + ": " + info.get("kind") + "\n" + table.text();
    }

    private static void append(TextTable table, String label, Object value) {
        if (value instanceof Map<?, ?> map && map.containsKey("from")) {
            String unit = map.get("unit").equals("1") ? "" : " " + map.get("unit");
            table.row(label, QuantityKey.format(map.get("value")) + unit, String.valueOf(map.get("from")));
        } else if (value instanceof Map<?, ?> map) {
            table.row(label, "", "");
            map.forEach((key, item) -> append(table, "  " + label.substring(0, 2) + key, item));
        } else if (value instanceof List<?> list && list.stream().anyMatch(item -> item instanceof String)) {
            table.row(label, "", "");
            list.forEach(item -> table.row("    " + item, "", ""));
        } else if (value instanceof List<?> list) {
            String items = list.stream().map(QuantityKey::format).collect(Collectors.joining("  "));
            table.row(label, items.isEmpty() ? "none" : items, "");
        } else {
            table.row(label, value == null ? "-" : QuantityKey.format(value), "");
        }
    }
}
