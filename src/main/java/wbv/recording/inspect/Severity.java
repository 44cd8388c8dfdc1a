package wbv.recording.inspect;

/** How much a finding matters. */
public enum Severity {
    /** Good to know; results stand. */
    NOTE,
    /** Results of the channels named may be wrong. */
    WARNING,
    /** The channels named, or the whole recording, cannot be used as they are. */
    FAULT
}
