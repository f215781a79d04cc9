// The shape of APT statements and expressions. It knows nothing of geometry forms (those are data of
// the definition room) and nothing of characters: the tokens come from frontend/lex, which knows cards,
// insignificant blanks and the vocabulary. One logical statement is parsed at a time.
parser grammar AptParser;

tokens {
  NUMBER, SYMBOL, WORD, TYPE, FUNCTION, IF, MACRO, CALL, STRING,
  COMMA, SLASH, LPAREN, RPAREN, EQUALS, PLUS, MINUS, STAR, POWER, RELATION, AND, OR, NOT,
  THEN, ELSE, ELSEIF, ENDIF, DO, ENDDO, INCLUDE
}

statement : label? body? EOF ;

label : (NUMBER | SYMBOL) RPAREN ;

body
  : target EQUALS definition                                      # define
  | target EQUALS MACRO (SLASH (parameter (COMMA parameter)*)?)?  # macro
  | target EQUALS expression                                      # assign
  | IF LPAREN expression RPAREN branch                            # if
  | ELSE                                                          # else
  | ELSEIF LPAREN expression RPAREN THEN                          # elseIf
  | ENDIF                                                         # endIf
  | DO SLASH target EQUALS expression COMMA expression (COMMA expression)?  # do
  | ENDDO                                                         # endDo
  | INCLUDE SLASH STRING                                          # include
  | CALL SLASH callItem (COMMA callItem)*                         # call
  | word (COMMA argument)* (SLASH arguments)?                     # command
  ;

branch : THEN | labelName COMMA labelName COMMA labelName ;

labelName : NUMBER | SYMBOL | WORD ;

target : (SYMBOL | WORD | TYPE | FUNCTION) (LPAREN expression RPAREN)? ;

definition : TYPE SLASH arguments ;

// A macro variable with its default; a CALL item with its value. What may stand as a value is checked later.
parameter : (SYMBOL | WORD | TYPE | FUNCTION) (EQUALS value)? ;
callItem : (SYMBOL | WORD | TYPE | FUNCTION) EQUALS value | argument ;
value : expression | word | STRING ;

// `)` followed by a word counts as `),word`.
arguments : argument (COMMA argument | word)* ;

argument : expression | word | STRING | ;

word : WORD | TYPE | FUNCTION | MACRO | IF | CALL ;

// A sign applies to the whole leading term (-A**2 is -(A**2)); ** groups to the right.
expression
  : primary                                       # atom
  | <assoc = right> expression POWER expression   # power
  | (PLUS | MINUS) expression                     # sign
  | expression (STAR | SLASH) expression          # multiply
  | expression (PLUS | MINUS) expression          # add
  | expression RELATION expression                # compare
  | NOT expression                                # not
  | expression AND expression                     # and
  | expression OR expression                      # or
  ;

primary
  : NUMBER
  | SYMBOL (LPAREN arguments RPAREN)?
  | FUNCTION LPAREN arguments RPAREN
  | LPAREN nested RPAREN
  ;

// Nested definition, nested assignment, parentheses, or the short form of a point.
nested
  : (target EQUALS)? definition
  | target EQUALS expression
  | expression (COMMA expression)*
  ;
