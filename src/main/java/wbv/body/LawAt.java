package wbv.body;

import wbv.body.law.Law;

/**
 * A law in a link of a structure.
 *
 * @param link index of the link
 * @param law what it adds to the linear force
 */
public record LawAt(int link, Law law) {}
